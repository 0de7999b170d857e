package nephele.engine.xmlscene;

/** @param line the line of its name */
record XmlAttribute(String name, String value, int line) {}
