package nephele.engine.level;

import static nephele.engine.level.BadLevel.file;
import static nephele.engine.level.BadLevel.level;
import static nephele.engine.level.BadLevel.repeated;
import static nephele.engine.level.BadLevel.wrap;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.List;
import nephele.engine.asset.SamplePictures;

/** Inputs that are no JSON, not the JSON of a level, or too large. */
final class BadDocuments {
    private static final String GOOD = wrap("\"name\": \"n\"");

    static final List<BadLevel> ALL = List.of(
            file("empty", "$", "is empty", ""),
            file("whitespace", "$", "is empty", " \n\t "),
            file("null", "$", "null is not allowed", "null"),
            file("array", "$", "must be an object", "[]"),
            file("text", "$", "must be an object", "\"level\""),
            file("number", "$", "must be an object", "1"),
            file("cut off in an object", "$", "ends too early", GOOD.substring(0, GOOD.length() - 1)),
            file("cut off in a text", "name", "Unterminated", GOOD.substring(0, GOOD.length() - 3)),
            file(
                    "cut off in an array",
                    "solids",
                    "ends too early",
                    wrap("\"solids\": [").replace("}", "")),
            bytes("UTF-16 little-endian", "UTF-16", GOOD.getBytes(StandardCharsets.UTF_16LE)),
            bytes("UTF-16 big-endian with mark", "UTF-16", GOOD.getBytes(StandardCharsets.UTF_16)),
            bytes("UTF-32", "UTF-32", GOOD.getBytes(Charset.forName("UTF-32BE"))),
            bytes("broken UTF-8", "not UTF-8", splice(new byte[] {(byte) 0xc3, 0x28})),
            bytes("overlong UTF-8", "not UTF-8", splice(new byte[] {(byte) 0xc0, (byte) 0xaf})),
            bytes("surrogate in UTF-8", "not UTF-8", splice(new byte[] {(byte) 0xed, (byte) 0xa0, (byte) 0x80})),
            bytes("zero-filled", "zero bytes", new byte[4096]),
            bytes("a picture", "", SamplePictures.png(4, 4, 8, 2, 1)),
            level("name", "surrogate", "\"name\": \"\\ud800\""),
            level("name", "surrogate", "\"name\": \"a\\udc00b\""),
            level("name", "control character", "\"name\": \"a\\u0000b\""),
            file("NUL in a text", "name", "not valid JSON", wrap("\"name\": \"a\u0000b\"")),
            file("line end in a text", "name", "not valid JSON", wrap("\"name\": \"a\nb\"")),
            deep("depth of arrays", "nested deeper", "[".repeat(100_000)),
            deep("depth of objects", "nested deeper", "{\"a\":".repeat(100_000)),
            file("over the cap", "$", "16 MiB", " ".repeat((16 << 20) + 1)),
            file("line comment", "$", "not valid JSON", "// hello\n" + GOOD),
            file("block comment", "$", "not valid JSON", "/* hello */" + GOOD),
            file("unquoted key", "$", "not valid JSON", "{format: \"nephele-level\"}"),
            file("single quotes", "$", "not valid JSON", "{'format': 'nephele-level'}"),
            file("trailing comma in an object", "$", "not valid JSON", GOOD.replace("}", ",}")),
            file("trailing comma in an array", "solids", "not valid JSON", wrap("\"solids\": [1,]")),
            file("missing comma", "$", "not valid JSON", GOOD.replace(", \"version", " \"version")),
            file("missing colon", "format", "not valid JSON", GOOD.replaceFirst(":", " ")),
            file("equals sign", "format", "not valid JSON", GOOD.replaceFirst(":", "=")),
            file("bad escape", "name", "not valid JSON", wrap("\"name\": \"\\q\"")),
            file("bad literal", "name", "not valid JSON", wrap("\"name\": truth")),
            file("two documents", "$", "not valid JSON", GOOD + GOOD),
            file("rubbish after the end", "$", "not valid JSON", GOOD + " x"),
            level("name", "twice", "\"name\": \"a\", \"name\": \"b\""),
            level("solids[0].id", "twice", "\"solids\": [{\"id\": \"a\", \"id\": \"b\"}]"),
            level("colour", "unknown key", "\"colour\": 1"),
            level("environment.sun.colour", "unknown key", "\"environment\": {\"sun\": {\"colour\": 1}}"),
            file("version missing", "version", "version", "{\"format\": \"nephele-level\"}"),
            file("format missing", "format", "nephele-level", "{\"version\": 1}"),
            file("another format", "format", "nephele-level", GOOD.replace("level\"", "replay\"")),
            file("version newer", "version", "newer", GOOD.replace("1", "2")),
            file("version 0", "version", "ever existed", GOOD.replace("1", "0")),
            file("version half", "version", "version", GOOD.replace("1", "1.5")),
            file("version as text", "version", "version", GOOD.replace("1", "\"1\"")),
            level("entities", "knows no entities", "\"entities\": [{}]"),
            level("entities", "an array", "\"entities\": {}"),
            large("nearly a million entities", "entities", "knows no entities", "\"entities\": [", "{}", 990_000),
            large("a hundred thousand lights", "lights", "at most", "\"lights\": [", "{\"id\":\"l\"}", 100_000),
            large("too many solids", "solids", "at most", "\"solids\": [", "{\"id\":\"s\",\"kind\":\"box\"}", 100_001),
            large("too many values", "more than 1000000 values", "\"solids\": [", "1", 1_100_000),
            large("large objects", "more than 1000000 values", "\"solids\": [", "{\"a\":1}", 1_600_000),
            large("nearly a million wrong elements", "solids", "at most", "\"solids\": [", "\"\"", 990_000),
            large(
                    "fifty thousand bad solids",
                    "solids[0]",
                    "is missing",
                    "\"solids\": [",
                    "{\"kind\":\"box\"}",
                    50_000),
            new BadLevel("an endless text", "name", "characters is wanted", () -> wrap("\"name\": \""
                            + "x".repeat(15 << 20) + "\"")
                    .getBytes(StandardCharsets.UTF_8)),
            new BadLevel("an endless key", "x".repeat(60) + "…", "unknown key", () -> wrap("\"" + "x".repeat(15 << 20)
                            + "\": 1")
                    .getBytes(StandardCharsets.UTF_8)),
            new BadLevel("too many keys", "k64", "keys in one object", BadDocuments::manyKeys));

    private BadDocuments() {}

    private static BadLevel deep(String name, String words, String text) {
        return new BadLevel(name, "", words, () -> text.getBytes(StandardCharsets.UTF_8));
    }

    private static BadLevel bytes(String name, String words, byte[] bytes) {
        return new BadLevel(name, "", words, () -> bytes);
    }

    private static BadLevel large(String name, String words, String start, String element, int count) {
        return large(name, "", words, start, element, count);
    }

    private static BadLevel large(String name, String path, String words, String start, String element, int count) {
        return new BadLevel(name, path, words, () -> wrap(start + repeated(element, count) + "]")
                .getBytes(StandardCharsets.UTF_8));
    }

    /** Returns a document with these bytes in the middle of a text. */
    private static byte[] splice(byte[] bytes) {
        byte[] all = GOOD.getBytes(StandardCharsets.UTF_8);
        System.arraycopy(bytes, 0, all, GOOD.indexOf("nephele"), bytes.length);
        return all;
    }

    private static byte[] manyKeys() {
        StringBuilder keys = new StringBuilder("{");
        for (int i = 0; i < 100_000; i++) {
            keys.append(i == 0 ? "" : ",").append("\"k").append(i).append("\":1");
        }
        return keys.append("}").toString().getBytes(StandardCharsets.UTF_8);
    }
}
