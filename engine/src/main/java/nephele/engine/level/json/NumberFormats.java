package nephele.engine.level.json;

import java.util.List;
import nephele.engine.level.Exposure;
import nephele.engine.level.NumberRange;
import nephele.engine.math.Vec3;

/** Formats of numbers and vectors, checked as doubles against a range. */
final class NumberFormats {
    private NumberFormats() {}

    /** A {@code number} of any primitive type; {@code fallback} is the value of an absent key. */
    record Real(NumberRange range, Double fallback) implements ValueFormat {
        @Override
        public Object read(JsonValue json, Problems problems) {
            return json instanceof JsonValue.Number number
                    ? inRange(number, range, problems)
                    : ValueFormat.mismatch("a number", json, problems);
        }

        @Override
        public JsonValue write(Object value) {
            return new JsonValue.Number((Double) value);
        }

        @Override
        public JsonValue.Members schema(SchemaDefinitions definitions) {
            return schemaOf("number", range);
        }

        @Override
        public Object absent() {
            return fallback;
        }
    }

    /** A number, or the word {@code "auto"}. */
    record RealOrAuto(Real number) implements ValueFormat {
        @Override
        public Object read(JsonValue json, Problems problems) {
            if (json instanceof JsonValue.Text text) {
                return text.value().equals(Exposure.AUTO_WORD)
                        ? Exposure.AUTO
                        : problems.error("must be a number or \"" + Exposure.AUTO_WORD + "\", not '"
                                + JsonTree.shortened(text.value()) + "'");
            } else if (!(json instanceof JsonValue.Number)) {
                return ValueFormat.mismatch("a number or \"" + Exposure.AUTO_WORD + "\"", json, problems);
            }
            Object stops = number.read(json, problems);
            return stops == null ? null : Exposure.ofStops((Double) stops);
        }

        @Override
        public JsonValue write(Object value) {
            Exposure exposure = (Exposure) value;
            return exposure.isAuto() ? new JsonValue.Text(Exposure.AUTO_WORD) : number.write(exposure.fixedStops());
        }

        @Override
        public JsonValue.Members schema(SchemaDefinitions definitions) {
            JsonValue word = new JsonValue.Members().with("const", new JsonValue.Text(Exposure.AUTO_WORD));
            return new JsonValue.Members()
                    .with("oneOf", new JsonValue.Array(List.of(number.schema(definitions), word)));
        }
    }

    /** An integer that fits its Java type; {@code narrow} converts it to an {@code Integer}. */
    record Whole(NumberRange range, boolean narrow) implements ValueFormat {
        @Override
        public Object read(JsonValue json, Problems problems) {
            if (!(json instanceof JsonValue.Number number)) {
                return ValueFormat.mismatch("a whole number", json, problems);
            }
            if (number.value() != Math.rint(number.value())) {
                return problems.error("this must be a whole number, not " + number.text());
            }
            Object checked = inRange(number, range, problems);
            return checked == null ? null : boxed((long) number.value());
        }

        private Object boxed(long value) {
            return narrow ? (Object) Math.toIntExact(value) : (Object) value;
        }

        @Override
        public JsonValue write(Object value) {
            return new JsonValue.Number(((java.lang.Number) value).doubleValue());
        }

        @Override
        public JsonValue.Members schema(SchemaDefinitions definitions) {
            return schemaOf("integer", range);
        }

        @Override
        public Object absent() {
            return boxed(0);
        }
    }

    /** {@code [x, y, z]}, with the same range for each component. */
    record Vector(NumberRange range) implements ValueFormat {
        @Override
        public Object read(JsonValue json, Problems problems) {
            if (!(json instanceof JsonValue.Array array)) {
                return ValueFormat.mismatch("an array of three numbers", json, problems);
            }
            if (array.values().size() != 3) {
                return problems.error(
                        "this must hold three numbers, not " + array.values().size());
            }
            Double x = component(array, 0, problems);
            Double y = component(array, 1, problems);
            Double z = component(array, 2, problems);
            if (x == null || y == null || z == null) {
                return null;
            }
            Vec3 vector = new Vec3(x, y, z);
            return range.reaches(vector)
                    ? vector
                    : problems.error("this direction has no length: give one that points somewhere");
        }

        private Double component(JsonValue.Array array, int index, Problems problems) {
            if (array.values().get(index) instanceof JsonValue.Number number && range.contains(number.value())) {
                return number.value();
            }
            int mark = problems.enter(index);
            Object value = new Real(range, null).read(array.values().get(index), problems);
            problems.leave(mark);
            return (Double) value;
        }

        @Override
        public JsonValue write(Object value) {
            Vec3 v = (Vec3) value;
            return new JsonValue.Array(
                    List.of(new JsonValue.Number(v.x()), new JsonValue.Number(v.y()), new JsonValue.Number(v.z())));
        }

        @Override
        public JsonValue.Members schema(SchemaDefinitions definitions) {
            JsonValue.Members schema = new JsonValue.Members()
                    .with("type", new JsonValue.Text("array"))
                    .with("items", schemaOf("number", range))
                    .with("minItems", new JsonValue.Number(3))
                    .with("maxItems", new JsonValue.Number(3));
            double reach = range.leastReach();
            return reach == 0
                    ? schema
                    : schema.with("contains", anyOf(limits(range.min(), -reach), limits(reach, range.max())));
        }
    }

    private static Object inRange(JsonValue.Number number, NumberRange range, Problems problems) {
        return range.contains(number.value())
                ? (Object) number.value()
                : problems.error(
                        "must be " + range.text("from %s to %s", " or ", NumberText::of) + ", not " + number.text());
    }

    private static JsonValue.Members schemaOf(String type, NumberRange range) {
        JsonValue.Members[] limits = range.stretches().stream()
                .map(stretch -> limits(stretch.min(), stretch.max()))
                .toArray(JsonValue.Members[]::new);
        JsonValue.Members schema = new JsonValue.Members().with("type", new JsonValue.Text(type));
        return limits.length > 1
                ? schema.with("anyOf", new JsonValue.Array(List.of(limits)))
                : schema.with("minimum", new JsonValue.Number(range.min()))
                        .with("maximum", new JsonValue.Number(range.max()));
    }

    private static JsonValue.Members anyOf(JsonValue.Members... schemas) {
        return new JsonValue.Members().with("anyOf", new JsonValue.Array(List.of(schemas)));
    }

    private static JsonValue.Members limits(double min, double max) {
        return min == max
                ? new JsonValue.Members().with("const", new JsonValue.Number(min))
                : new JsonValue.Members()
                        .with("minimum", new JsonValue.Number(min))
                        .with("maximum", new JsonValue.Number(max));
    }
}
