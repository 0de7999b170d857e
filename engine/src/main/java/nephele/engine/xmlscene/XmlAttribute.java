package nephele.engine.xmlscene;

/** @param line where its name stands */
record XmlAttribute(String name, String value, int line) {}
