package nephele.scenes.xml;

/** @param line the line of its name */
record XmlAttribute(String name, String value, int line) {}
