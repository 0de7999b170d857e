package nephele.engine.level.json;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** The format of a sealed interface's records; {@code kind} is the record's name in lower case. */
record VariantFormat(List<Class<?>> types, List<String> kinds, List<RecordFormat> formats) implements MembersFormat {
    private static final String KIND = "kind";

    static String kind(Class<?> type) {
        return type.getSimpleName().toLowerCase(Locale.ROOT);
    }

    @Override
    public Object readMembers(JsonValue.Members members, Problems problems) {
        JsonValue kind = members.ask(KIND);
        int index = kind instanceof JsonValue.Text text ? kinds.indexOf(text.value()) : -1;
        if (index >= 0) {
            return formats.get(index).readMembers(members, problems);
        }
        // The kind decides which keys are known; without a kind, no key is reported as unknown.
        names().forEach(members::ask);
        int mark = problems.enter(KIND);
        String found = kind instanceof JsonValue.Text text ? "'" + JsonTree.shortened(text.value()) + "'" : "this";
        problems.error(
                kind == null ? "is missing: one of " + kinds : found + " is no kind that is known here: " + kinds);
        problems.leave(mark);
        return null;
    }

    @Override
    public void writeMembers(Object value, JsonValue.Members members) {
        int index = types.indexOf(value.getClass());
        int before = members.size();
        formats.get(index).writeMembers(value, members);
        boolean named = members.size() > before && members.name(before).equals("id");
        members.insert(named ? before + 1 : before, KIND, new JsonValue.Text(kinds.get(index)));
    }

    @Override
    public List<String> names() {
        Set<String> names = new LinkedHashSet<>(List.of(KIND));
        formats.forEach(format -> names.addAll(format.names()));
        return List.copyOf(names);
    }

    @Override
    public JsonValue.Members schema(SchemaDefinitions definitions) {
        List<JsonValue> variants = new ArrayList<>();
        for (int i = 0; i < types.size(); i++) {
            RecordFormat format = formats.get(i);
            String kind = kinds.get(i);
            variants.add(definitions.reference(
                    types.get(i), () -> SchemaDefinitions.closed(format.schemaOfVariant(kind, definitions))));
        }
        return new JsonValue.Members().with("oneOf", new JsonValue.Array(variants));
    }

    @Override
    public JsonValue.Members schemaBeside(SchemaDefinitions definitions) {
        List<JsonValue> variants = new ArrayList<>();
        for (int i = 0; i < types.size(); i++) {
            variants.add(formats.get(i).schemaOfVariant(kinds.get(i), definitions));
        }
        return new JsonValue.Members().with("oneOf", new JsonValue.Array(variants));
    }
}
