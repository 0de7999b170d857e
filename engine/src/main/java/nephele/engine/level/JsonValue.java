package nephele.engine.level;

import java.util.ArrayList;
import java.util.List;

/** A JSON document in memory. */
sealed interface JsonValue {
    record Text(String value) implements JsonValue {}

    record Number(double value) implements JsonValue {}

    enum Literal implements JsonValue {
        TRUE,
        FALSE,
        NULL
    }

    record Array(List<JsonValue> values) implements JsonValue {}

    /** Members in file order; remembers which ones were asked for, so that the rest can be called unknown. */
    final class Members implements JsonValue {
        private final List<String> names = new ArrayList<>(8);
        private final List<JsonValue> values = new ArrayList<>(8);
        private long asked;

        /** Past this many the object cannot be one of ours; it bounds the linear searches. */
        static final int MOST = Long.SIZE;

        Members with(String name, JsonValue value) {
            names.add(name);
            values.add(value);
            return this;
        }

        void insert(int index, String name, JsonValue value) {
            names.add(index, name);
            values.add(index, value);
        }

        boolean contains(String name) {
            return names.contains(name);
        }

        int size() {
            return names.size();
        }

        String name(int index) {
            return names.get(index);
        }

        JsonValue value(int index) {
            return values.get(index);
        }

        /** The member's value, or {@code null}; marks it as known. */
        JsonValue ask(String name) {
            int index = names.indexOf(name);
            if (index < 0) {
                return null;
            }
            asked |= 1L << index;
            return values.get(index);
        }

        /** The names that nobody asked for. */
        List<String> unknown() {
            if (asked == -1L >>> (Long.SIZE - names.size()) || names.isEmpty()) {
                return List.of();
            }
            List<String> unknown = new ArrayList<>();
            for (int i = 0; i < names.size(); i++) {
                if ((asked >>> i & 1) == 0) {
                    unknown.add(names.get(i));
                }
            }
            return unknown;
        }
    }

    /** How a message calls this kind of value. */
    default String kind() {
        if (this instanceof Text) {
            return "a text";
        } else if (this instanceof Number) {
            return "a number";
        } else if (this instanceof Array) {
            return "an array";
        } else if (this instanceof Members) {
            return "an object";
        }
        return this == Literal.NULL ? "null" : "true or false";
    }
}
