package nephele.engine.level.json;

import java.util.ArrayList;
import java.util.List;

/** A record written as an array of its members, such as {@code [low, high]}. */
record TupleFormat(RecordFormat members) implements ValueFormat {
    @Override
    public Object read(JsonValue json, Problems problems) {
        int count = members.fieldCount();
        if (!(json instanceof JsonValue.Array array)) {
            return ValueFormat.mismatch("an array: " + names(), json, problems);
        }
        if (array.values().size() != count) {
            return problems.error("this must hold " + count + " numbers, " + names() + ", not "
                    + array.values().size());
        }
        Object[] values = new Object[count];
        int before = problems.count();
        for (int i = 0; i < count; i++) {
            int mark = problems.enter(i);
            values[i] = members.field(i).format().read(array.values().get(i), problems);
            problems.leave(mark);
        }
        return problems.count() > before ? null : members.make(values);
    }

    private String names() {
        return "[" + String.join(", ", members.names()) + "]";
    }

    @Override
    public JsonValue write(Object value) {
        List<JsonValue> values = new ArrayList<>();
        for (int i = 0; i < members.fieldCount(); i++) {
            FieldFormat field = members.field(i);
            values.add(field.format().write(field.get(value)));
        }
        return new JsonValue.Array(values);
    }

    @Override
    public JsonValue.Members schema(SchemaDefinitions definitions) {
        List<JsonValue> items = new ArrayList<>();
        for (int i = 0; i < members.fieldCount(); i++) {
            items.add(members.field(i).format().schema(definitions));
        }
        return new JsonValue.Members()
                .with("type", new JsonValue.Text("array"))
                .with("prefixItems", new JsonValue.Array(items))
                .with("items", JsonValue.Literal.FALSE)
                .with("minItems", new JsonValue.Number(items.size()));
    }
}
