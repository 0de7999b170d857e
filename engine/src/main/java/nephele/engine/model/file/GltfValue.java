package nephele.engine.model.file;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.Iterator;
import java.util.stream.IntStream;
import nephele.engine.model.ModelFileException;

/**
 * A value in a glTF file's JSON, with its path, which errors name.
 *
 * @param json {@code null} if the member is missing
 */
record GltfValue(String file, String path, JsonElement json) {
    boolean exists() {
        return json != null;
    }

    GltfValue member(String name) {
        if (!(json instanceof JsonObject object)) {
            throw error("is no object");
        }
        return new GltfValue(file, path.isEmpty() ? name : path + "." + name, object.get(name));
    }

    /** Returns a member, missing if this value is. */
    GltfValue memberIfAny(String name) {
        return exists() ? member(name) : this;
    }

    /** Returns the number of elements of an array; 0 if it is missing. */
    int size() {
        if (json == null) {
            return 0;
        }
        if (!(json instanceof JsonArray array)) {
            throw error("is no array");
        }
        return array.size();
    }

    GltfValue at(int i) {
        return new GltfValue(file, path + "[" + i + "]", ((JsonArray) json).get(i));
    }

    Iterable<GltfValue> elements() {
        return () -> elementIterator(size());
    }

    private Iterator<GltfValue> elementIterator(int size) {
        return IntStream.range(0, size).mapToObj(this::at).iterator();
    }

    String text(String missing) {
        if (json == null) {
            return missing;
        }
        if (!(json instanceof JsonPrimitive primitive) || !primitive.isString()) {
            throw error("is no text");
        }
        return primitive.getAsString();
    }

    double number() {
        double value =
                json instanceof JsonPrimitive primitive && primitive.isNumber() ? primitive.getAsDouble() : Double.NaN;
        if (!(Math.abs(value) <= Float.MAX_VALUE)) {
            throw error("is no number that a float holds");
        }
        return value;
    }

    /** Returns a number of an array of {@code size} numbers; {@code missing} if there is no array. */
    double numberAt(int i, int size, double missing) {
        if (exists() && size() != size) {
            throw error("has " + size() + " numbers instead of " + size);
        }
        return exists() ? at(i).number() : missing;
    }

    /** Returns a non-negative integer; {@code missing} if there is none. */
    int count(int missing) {
        if (json == null) {
            return missing;
        }
        double value = number();
        if (value != Math.rint(value) || value < 0 || value > Integer.MAX_VALUE) {
            throw error("is no whole number from 0");
        }
        return (int) value;
    }

    int count() {
        if (json == null) {
            throw error("is missing");
        }
        return count(0);
    }

    /** Returns an integer below {@code limit}, an index into {@code what}. */
    int index(int limit, String what) {
        int index = count();
        if (index >= limit) {
            throw error("is " + index + ", but there are " + limit + " " + what);
        }
        return index;
    }

    boolean flag() {
        if (json == null) {
            return false;
        }
        if (!(json instanceof JsonPrimitive primitive) || !primitive.isBoolean()) {
            throw error("is neither true nor false");
        }
        return primitive.getAsBoolean();
    }

    ModelFileException error(String reason) {
        return error(reason, "export the mesh again");
    }

    ModelFileException error(String reason, String remedy) {
        return new ModelFileException(file, 0, (path.isEmpty() ? "the JSON" : path) + " " + reason, remedy);
    }
}
