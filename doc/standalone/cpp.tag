<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<!-- The pages on the C++ standard that this manual links to, written by hand. -->
<tagfile>
  <compound kind="class">
    <name>CopyConstructible</name>
    <filename>named_req/CopyConstructible.html</filename>
  </compound>
  <compound kind="class">
    <name>DefaultConstructible</name>
    <filename>named_req/DefaultConstructible.html</filename>
  </compound>
  <compound kind="class">
    <name>CopyAssignable</name>
    <filename>named_req/CopyAssignable.html</filename>
  </compound>
</tagfile>
