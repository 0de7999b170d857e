package nephele.app.corpus;

import java.util.Locale;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** A level unlike those that authors make, as the text of its file. */
record OddLevel(String name, String text) {
    static final String CAMERA = "\"cameras\": [{\"id\": \"main\", \"position\": [0, 1.6, 5], \"target\": [0, 1, 0]}]";
    private static final String FLOOR =
            "{\"id\": \"floor\", \"kind\": \"box\", \"centre\": [0, -0.5, 0], \"size\": [20, 1, 20]}";

    /** Returns a level with these sections and no others. */
    static OddLevel bare(String name, String sections) {
        String comma = sections.isEmpty() ? "" : ", ";
        return new OddLevel(name, "{\"format\": \"nephele-level\", \"version\": 1" + comma + sections + "}");
    }

    /** Returns a level with these sections, a sun, a camera and a player. */
    static OddLevel seen(String name, String sections) {
        String environment = sections.contains("\"environment\"")
                ? ""
                : ", \"environment\": {\"sun\": {\"directionTowardsSun\": [1, 2, 1], \"irradiance\": [3, 3, 3]}}";
        String player = sections.contains("\"player\"") ? "" : ", \"player\": {\"feet\": [0, 0, 4]}";
        String camera = sections.contains("\"cameras\"") ? "" : ", " + CAMERA;
        return bare(name, sections + environment + player + camera);
    }

    /** Returns a level with a floor and these further solids. */
    static OddLevel solids(String name, String solids) {
        return seen(name, floorAnd(solids));
    }

    static String floorAnd(String solids) {
        return "\"solids\": [" + FLOOR + (solids.isEmpty() ? "" : ", " + solids) + "]";
    }

    static String box(String id, String centre, String size) {
        return "{\"id\": \"" + id + "\", \"kind\": \"box\", \"centre\": " + centre + ", \"size\": " + size + "}";
    }

    static String body(String id, String centre, String size, String kilograms) {
        return "{\"id\": \"" + id + "\", \"kind\": \"box\", \"centre\": " + centre + ", \"size\": " + size
                + ", \"massKilograms\": " + kilograms + "}";
    }

    /** @param measures the remaining fields of the record: normal, width and so on */
    static String portal(String id, String linkedTo, String centre, String measures) {
        return "{\"id\": \"" + id + "\", \"linkedTo\": \"" + linkedTo + "\", \"centre\": " + centre + ", " + measures
                + "}";
    }

    static String model(String id, String file, String steps) {
        return "{\"id\": \"" + id + "\", \"file\": \"" + file + "\", \"transform\": [" + steps + "]}";
    }

    static String scale(String by) {
        return "{\"kind\": \"scale\", \"by\": " + by + "}";
    }

    static String many(int count, IntFunction<String> record) {
        return IntStream.range(0, count).mapToObj(record).collect(Collectors.joining(", "));
    }

    static String vector(double x, double y, double z) {
        return String.format(Locale.ROOT, "[%s, %s, %s]", x, y, z);
    }

    @Override
    public String toString() {
        return name;
    }
}
