<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<!-- The pages of Boost that this manual links to, written by hand. -->
<tagfile>
  <compound kind="class">
    <name>ReadablePropertyMap</name>
    <filename>property_map/doc/ReadablePropertyMap.html</filename>
  </compound>
  <compound kind="class">
    <name>WritablePropertyMap</name>
    <filename>property_map/doc/WritablePropertyMap.html</filename>
  </compound>
  <compound kind="class">
    <name>ReadWritePropertyMap</name>
    <filename>property_map/doc/ReadWritePropertyMap.html</filename>
  </compound>
  <compound kind="class">
    <name>LvaluePropertyMap</name>
    <filename>property_map/doc/LvaluePropertyMap.html</filename>
  </compound>
</tagfile>
