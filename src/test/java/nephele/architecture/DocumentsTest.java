package nephele.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The pages for people: links lead to files, names of code exist, and the list of decisions is complete. */
@Execution(ExecutionMode.CONCURRENT)
class DocumentsTest {
    private static final Path DECISIONS = Path.of("docs/decisions");

    /** The page of old names, and the page of changes, whose names were right on their day. */
    private static final Set<String> OF_THE_PAST = Set.of("docs/renamed.md", "CHANGELOG.md");

    private static final Pattern NAME = Pattern.compile("([a-z]\\w*\\.)*[A-Z]\\w*[a-z]\\w*([.#]\\w+)*(\\(\\))?");
    private static final Pattern CAMEL_CASE = Pattern.compile("(?<![\\w./-])[A-Z][a-z0-9]+[A-Z]\\w*");

    /** What looks like a name of ours: of the JDK, a file format, a key, and what was removed. */
    private static final Set<String> OTHERS = Set.of(
            "Math.sin",
            "StrictMath",
            "Double.toString",
            "PrintStream",
            "--size WxH",
            "KHR_texture_transform",
            "KHR_mesh_quantization",
            "NaN",
            "Space",
            "Up",
            "Weld",
            "PlaneSide");

    /** Names in comments that are no types of ours: people, formats, keys, programs, and the placeholder of a name. */
    private static final Set<String> WORDS = Set.of(
            "MiB",
            "KiB",
            "AltGr",
            "AxisAngle4",
            "PageUp",
            "PageDown",
            "SplitMix64",
            "NaNs",
            "TwelveMonkeys",
            "OpenImageIO",
            "HyAB",
            "YyCxCz",
            "FidelityFX",
            "McGuire",
            "McTaggart",
            "WxH");

    private static final Pattern COMMENT = Pattern.compile("//[^\n]*|/\\*[^*]*+\\*++(?:[^/*][^*]*+\\*++)*+/");
    private static final Pattern TEXT = Pattern.compile("\"(?:\\\\.|[^\"\\\\\n])*+\"");

    @Test
    void linksLeadToFiles() throws IOException {
        List<String> broken = new ArrayList<>();
        for (Path page : pages()) {
            for (String link : groups("\\]\\(([^)#\\s:]+)(?:#[^)]*)?\\)", Files.readString(page))) {
                if (!Files.exists(page.toAbsolutePath().resolveSibling(link))) {
                    broken.add(page + ": " + link);
                }
            }
        }
        assertEquals(List.of(), broken);
    }

    @Test
    void theListOfDecisionsNamesEachInItsOrder() throws IOException {
        String list = Files.readString(DECISIONS.resolve("README.md"));
        Set<String> listed = new TreeSet<>();
        for (String section : list.split("(?m)^## ", -1)) {
            for (String file : groups("\\A\\[[^]]*]\\(([^)]+)\\)", section)) {
                listed.add(file);
                String page = Files.readString(DECISIONS.resolve(file));
                assertEquals(groups("(?m)^## (.*)$", page), groups("(?m)^\\* (.*)$", section), file);
            }
        }
        try (Stream<Path> files = Files.list(DECISIONS)) {
            assertEquals(
                    files.map(file -> file.getFileName().toString())
                            .filter(name -> !name.equals("README.md"))
                            .collect(Collectors.toCollection(TreeSet::new)),
                    listed);
        }
    }

    @Test
    void namesOfCodeExist() throws IOException {
        Map<String, List<SourceFile>> types = new TreeMap<>();
        for (SourceFile file : SourceFile.all()) {
            groups("\\b(?:class|interface|enum|record)\\s+([A-Z]\\w*)", file.text())
                    .forEach(type -> types.computeIfAbsent(type, absent -> new ArrayList<>())
                            .add(file));
        }
        List<String> unknown = new ArrayList<>();
        for (Path page : pages()) {
            for (String code : groups("`([^`\n]+)`", Files.readString(page))) {
                boolean exists = NAME.matcher(code).matches()
                        ? isOurs(code, types)
                        : CAMEL_CASE
                                .matcher(code)
                                .results()
                                .map(MatchResult::group)
                                .allMatch(types::containsKey);
                if (!exists && !OTHERS.contains(code)) {
                    unknown.add(page + ": " + code);
                }
            }
        }
        assertEquals(List.of(), unknown);
    }

    /** Returns true for a type, if need be with the end of its package before it and a member behind it. */
    private static boolean isOurs(String code, Map<String, List<SourceFile>> types) {
        String[] words = code.replace("()", "").split("[.#]");
        int first = 0;
        while (Character.isLowerCase(words[first].charAt(0))) {
            first++;
        }
        String folder =
                "/" + Arrays.stream(words).limit(first).map(word -> word + "/").collect(Collectors.joining());
        Pattern member = Pattern.compile("\\b" + words[words.length - 1] + "\\b");
        return types.getOrDefault(words[first], List.of()).stream()
                .anyMatch(file -> file.path().contains(folder)
                        && member.matcher(file.text()).find());
    }

    /** Types, files of shaders and pages that comments name; a type that code uses exists. */
    @Test
    void namesInCommentsExist() throws IOException {
        List<SourceFile> sources = SourceFile.all();
        Set<String> used = new TreeSet<>();
        Set<String> paths = new TreeSet<>();
        for (SourceFile file : sources) {
            paths.add("/" + file.path());
            used.addAll(
                    groups("\\b([A-Z]\\w+)", COMMENT.matcher(withoutTexts(file)).replaceAll(" ")));
        }
        List<String> unknown = new ArrayList<>();
        for (SourceFile file : sources) {
            for (String comment : groups("(" + COMMENT.pattern() + ")", withoutTexts(file))) {
                Stream<String> types = CAMEL_CASE.matcher(comment).results().map(MatchResult::group);
                types.filter(type -> !used.contains(type) && !WORDS.contains(type))
                        .forEach(type -> unknown.add(file.path() + ": " + type));
                Stream<String> files = Stream.of(
                                groups("/?([\\w-][\\w/-]*\\.(?:glsl|vert|frag|geom))\\b", comment).stream(),
                                groups("\\bnephele\\.((?:[a-z]\\w*\\.)+[A-Z]\\w*)", comment).stream()
                                        .map(type -> type.replace('.', '/') + ".java"),
                                groups("\\b(docs/[\\w./-]+\\w)", comment).stream())
                        .flatMap(found -> found);
                files.filter(name -> !Files.exists(Path.of(name))
                                && paths.stream().noneMatch(path -> path.endsWith("/" + name)))
                        .forEach(name -> unknown.add(file.path() + ": " + name));
            }
        }
        assertEquals(List.of(), unknown);
    }

    private static String withoutTexts(SourceFile file) {
        return TEXT.matcher(file.text()).replaceAll("\"\"");
    }

    private static List<Path> pages() throws IOException {
        try (Stream<Path> root = Files.list(Path.of("."));
                Stream<Path> docs = Files.walk(Path.of("docs"))) {
            return Stream.concat(root, docs)
                    .map(Path::normalize)
                    .filter(page -> page.toString().endsWith(".md") && !OF_THE_PAST.contains(page.toString()))
                    .sorted()
                    .toList();
        }
    }

    private static List<String> groups(String pattern, String text) {
        return Pattern.compile(pattern)
                .matcher(text)
                .results()
                .map(match -> match.group(1))
                .toList();
    }
}
