<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>esm::ChangedFilesBar</name>
    <message numerus="yes">
        <source>%n file(s) of the model changed since the import: %1</source>
        <translation>
            <numerusform>%n file of the model changed since the import: %1</numerusform>
            <numerusform>%n files of the model changed since the import: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>esm::DefectList</name>
    <message numerus="yes">
        <source>Border of %n edge(s), %1 mm long</source>
        <translation>
            <numerusform>Border of %n edge, %1 mm long</numerusform>
            <numerusform>Border of %n edges, %1 mm long</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Part of %n element(s)</source>
        <translation>
            <numerusform>Part of %n element</numerusform>
            <numerusform>Part of %n elements</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>esm::ImportDialog</name>
    <message numerus="yes">
        <source>Import %1 and %n more file(s)</source>
        <translation>
            <numerusform>Import %1 and %n more file</numerusform>
            <numerusform>Import %1 and %n more files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n motion(s) of the net that no spring resists</source>
        <translation>
            <numerusform>%n motion of the net that no spring resists</numerusform>
            <numerusform>%n motions of the net that no spring resists</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) that nothing holds across the plane of their springs</source>
        <translation>
            <numerusform>%n node that nothing holds across the plane of its springs</numerusform>
            <numerusform>%n nodes that nothing holds across the plane of their springs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) at which parts hang together alone</source>
        <translation>
            <numerusform>%n node at which alone parts hang together</numerusform>
            <numerusform>%n nodes at which alone parts hang together</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) of lines along which parts hang together alone</source>
        <translation>
            <numerusform>%n node of lines along which alone parts hang together</numerusform>
            <numerusform>%n nodes of lines along which alone parts hang together</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n part(s) that neither bands nor held nodes hold</source>
        <translation>
            <numerusform>%n part that neither bands nor held nodes hold</numerusform>
            <numerusform>%n parts that neither bands nor held nodes hold</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>esm::MainWindow</name>
    <message numerus="yes">
        <source>Drop to import %n file(s)</source>
        <translation>
            <numerusform>Drop to import %n file</numerusform>
            <numerusform>Drop to import %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>esm::Overlay</name>
    <message numerus="yes">
        <source>Select: %n node(s); Shift adds, Ctrl takes away, Esc clears</source>
        <translation>
            <numerusform>Select: %n node; Shift adds, Ctrl takes away, Esc clears</numerusform>
            <numerusform>Select: %n nodes; Shift adds, Ctrl takes away, Esc clears</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>esm::ProblemsView</name>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problem</numerusform>
            <numerusform>%n problems</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>esm::RegionFields</name>
    <message numerus="yes">
        <source>%n spring(s)</source>
        <translation>
            <numerusform>%n spring</numerusform>
            <numerusform>%n springs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>esm::RuleMatrixPage</name>
    <message numerus="yes">
        <source>%n rule(s) for this result also ask about other inputs and are not shown here.</source>
        <translation>
            <numerusform>%n rule for this result also asks about other inputs and is not shown here.</numerusform>
            <numerusform>%n rules for this result also ask about other inputs and are not shown here.</numerusform>
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
<context>
    <name>esm::RecoveryDialog</name>
    <message numerus="yes">
        <source>%n step(s), never saved</source>
        <translation>
            <numerusform>%n step, never saved</numerusform>
            <numerusform>%n steps, never saved</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) after the last save</source>
        <translation>
            <numerusform>%n step after the last save</numerusform>
            <numerusform>%n steps after the last save</numerusform>
        </translation>
    </message>
</context>
</TS>
