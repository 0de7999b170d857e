package nephele.engine.level;

import nephele.engine.asset.AssetId;

/** Texts, by what they may consist of. */
record TextFormat(Rule rule, String fallback) implements ValueFormat {
    /** Kinds of text. Public, because annotations outside the package hold one. */
    public enum Rule {
        /** One line for people. */
        NAME(0, 200),
        /** Several lines for people. */
        PROSE(0, 10_000),
        /** Names a record, or refers to one. */
        ID(1, 128),
        /** A file, after {@link AssetId}. */
        ASSET(1, AssetId.MAX_LENGTH);

        private final int shortest;
        private final int longest;

        Rule(int shortest, int longest) {
            this.shortest = shortest;
            this.longest = longest;
        }
    }

    @Override
    public Object read(JsonValue json, Problems problems) {
        if (!(json instanceof JsonValue.Text text)) {
            return ValueFormat.mismatch("a text", json, problems);
        }
        String objection = objection(text.value());
        return objection == null ? text.value() : problems.error(objection);
    }

    private String objection(String text) {
        if (text.length() < rule.shortest || text.length() > rule.longest) {
            return "a text of " + rule.shortest + " to " + rule.longest + " characters is wanted, this one has "
                    + text.length();
        }
        if (rule == Rule.ASSET) {
            return AssetId.objection(text);
        }
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (Character.isISOControl(c) && !(rule == Rule.PROSE && (c == '\n' || c == '\t'))) {
                return "the text holds a control character at position " + i;
            }
        }
        return null;
    }

    @Override
    public JsonValue write(Object value) {
        return new JsonValue.Text((String) value);
    }

    @Override
    public JsonValue.Members schema(SchemaDefinitions definitions) {
        var schema = new JsonValue.Members()
                .with("type", new JsonValue.Text("string"))
                .with("minLength", new JsonValue.Number(rule.shortest))
                .with("maxLength", new JsonValue.Number(rule.longest));
        return rule == Rule.ASSET
                ? schema.with("pattern", new JsonValue.Text("^[A-Za-z0-9._][A-Za-z0-9._/-]*$"))
                : schema;
    }

    @Override
    public Object absent() {
        return fallback;
    }
}
