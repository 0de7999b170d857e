package nephele.engine.level.json;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** A JSON document in memory. */
sealed interface JsonValue {
    record Text(String value) implements JsonValue {}

    /**
     * A number.
     *
     * @param authored its text in the file if the value can be another number, {@code null} otherwise: not every whole number
     *     above 2^53 has a double
     */
    record Number(double value, String authored) implements JsonValue {
        Number(double value) {
            this(value, null);
        }

        /** Returns the number that the author wrote, for messages. */
        String text() {
            return authored != null ? authored : Double.isFinite(value) ? NumberText.of(value) : Double.toString(value);
        }
    }

    enum Literal implements JsonValue {
        TRUE,
        FALSE,
        NULL
    }

    record Array(List<JsonValue> values) implements JsonValue {}

    /** Members in file order. Records which ones were read, so that the others can be reported as unknown. */
    final class Members implements JsonValue {
        /** Upper bound of the number of members, which limits the linear searches; no valid object has more. */
        static final int MOST = Long.SIZE;

        private static final int USUAL = 4;

        private String[] names = new String[USUAL];
        private JsonValue[] values = new JsonValue[USUAL];
        private int size;
        private long asked;

        Members with(String name, JsonValue value) {
            insert(size, name, value);
            return this;
        }

        void insert(int index, String name, JsonValue value) {
            if (size == names.length) {
                names = Arrays.copyOf(names, 2 * size);
                values = Arrays.copyOf(values, 2 * size);
            }
            System.arraycopy(names, index, names, index + 1, size - index);
            System.arraycopy(values, index, values, index + 1, size - index);
            names[index] = name;
            values[index] = value;
            size++;
        }

        boolean contains(String name) {
            return index(name) >= 0;
        }

        int size() {
            return size;
        }

        String name(int index) {
            return names[index];
        }

        JsonValue value(int index) {
            return values[index];
        }

        /** Returns the member's value, or {@code null}; marks it as known. */
        JsonValue ask(String name) {
            int index = index(name);
            if (index < 0) {
                return null;
            }
            asked |= 1L << index;
            return values[index];
        }

        /** Returns the names that have not been read. */
        List<String> unknown() {
            if (Long.bitCount(asked) == size) {
                return List.of();
            }
            List<String> unknown = new ArrayList<>();
            for (int i = 0; i < size; i++) {
                if ((asked >>> i & 1) == 0) {
                    unknown.add(names[i]);
                }
            }
            return unknown;
        }

        private int index(String name) {
            for (int i = 0; i < size; i++) {
                if (names[i].equals(name)) {
                    return i;
                }
            }
            return -1;
        }
    }

    /** Returns the name of this kind of value in messages. */
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
