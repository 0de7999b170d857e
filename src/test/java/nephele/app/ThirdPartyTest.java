package nephele.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** THIRD-PARTY.md lists the libraries of the class path with their versions, and the folder of licences has each text. */
class ThirdPartyTest {
    private static final Path LIST = Path.of("THIRD-PARTY.md");
    private static final Path LICENCES = Path.of("licences");
    private static final Pattern JAR = Pattern.compile("(.+?)-(\\d[\\w.]*)(-natives-[\\w-]+)?\\.jar");

    /** Libraries that only tests use. */
    private static final Pattern OF_TESTS =
            Pattern.compile("junit-.*|opentest4j|open-test-reporting-.*|apiguardian-.*|archunit.*|slf4j-.*|jspecify");

    /** A row of the table: library, version, its jars, licence, text. */
    private record Row(String version, List<String> jars, String text) {
        static Row of(String line) {
            String[] cells = line.split("\\|");
            List<String> jars = Stream.of(cells[3].split(","))
                    .map(String::strip)
                    .filter(jar -> !jar.isEmpty())
                    .toList();
            return new Row(cells[2].strip(), jars, cells[5].strip());
        }
    }

    private static List<Row> rows() throws IOException {
        return Files.readAllLines(LIST).stream()
                .filter(line -> line.startsWith("| ") && !line.startsWith("| library"))
                .map(Row::of)
                .toList();
    }

    @Test
    void theListIsTheClassPath() throws IOException {
        Set<String> listed = rows().stream()
                .flatMap(row -> row.jars.stream().map(jar -> jar + " " + row.version))
                .collect(Collectors.toCollection(TreeSet::new));
        Set<String> used = new TreeSet<>();
        for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
            Matcher jar = JAR.matcher(Path.of(entry).getFileName().toString());
            if (jar.matches() && !OF_TESTS.matcher(jar.group(1)).matches()) {
                used.add(jar.group(1) + " " + jar.group(2));
            }
        }
        assertEquals(used, listed);
    }

    @Test
    void eachLibraryHasTheTextOfItsLicence() throws IOException {
        Set<String> named = new TreeSet<>();
        for (Row row : rows()) {
            named.add(row.text);
            String text = Files.readString(LICENCES.resolve(row.text));
            assertTrue(text.contains("AS IS") || text.contains("'as-is'"), row.text);
        }
        try (Stream<Path> files = Files.list(LICENCES)) {
            Set<String> texts =
                    files.map(file -> file.getFileName().toString()).collect(Collectors.toCollection(TreeSet::new));
            assertEquals(texts, named);
        }
    }

    @Test
    void theJarGetsTheListAndTheTexts() throws IOException {
        String build = Files.readString(Path.of("app", "build.gradle"));
        assertTrue(build.contains("from(rootProject.files('LICENSE', 'THIRD-PARTY.md'))"));
        assertTrue(build.contains("from(rootProject.file('licences'))"));
        assertFalse(build.contains("project(':workshop')"), "the jar holds no proof, painter or solver");
    }
}
