<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>esm::RegionsPanel</name>
    <message numerus="yes">
        <source>%n spring(s)</source>
        <translation>
            <numerusform>%n spring</numerusform>
            <numerusform>%n springs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>esm::StatusStrip</name>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n node</numerusform>
            <numerusform>%n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n spring(s)</source>
        <translation>
            <numerusform>%n spring</numerusform>
            <numerusform>%n springs</numerusform>
        </translation>
    </message>
</context>
</TS>
