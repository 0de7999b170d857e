package nephele.quick;

import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;

import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.platform.launcher.Launcher;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;
import org.junit.platform.launcher.listeners.SummaryGeneratingListener;
import org.junit.platform.launcher.listeners.TestExecutionSummary;

/**
 * Runs pure test classes, those of changed sources first, then the fastest of each package, the second fastest and so
 * on, until a time of day. The times are those of the last whole run; without one, shorter sources count as faster.
 * No test needs OpenGL or a window. The last line is {@code N passed, N failed}.
 */
public final class QuickTests {
    private static final double LETTERS_A_SECOND = 20_000;
    private static final Path SOURCES = Path.of("src", "test", "java");
    private static final List<String> NOT_PURE =
            List.of("GlTest.java", "SwingTest.java", "ReplayTest.java", "ProofTest.java");
    private static final Path REPORTS = Path.of("build", "test-results", "test");
    private static final Pattern TEST_CASE =
            Pattern.compile("<testcase .*?classname=\"([^\"$]*).*? time=\"([0-9.]+)\"");

    private final PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    private final Launcher launcher = LauncherFactory.create();
    private final SummaryGeneratingListener listener = new SummaryGeneratingListener();

    private long passed;
    private long failed;

    private QuickTests() {}

    /** @param end the time after which only tests of changed sources start, in seconds since 1970 */
    public static void main(String[] end) throws IOException, InterruptedException {
        System.exit(new QuickTests().run(Instant.ofEpochSecond(Long.parseLong(end[0]))) ? 0 : 1);
    }

    /** Returns whether tests ran and all passed. */
    private boolean run(Instant end) throws IOException, InterruptedException {
        List<Path> tests = pureTests();
        Set<Path> order = ofChanges(tests, changedNames());
        int ofChanges = order.size();
        order.addAll(fastestOfEachPackage(tests));
        int classes = 0;
        for (Path test : order) {
            if (classes >= ofChanges && Instant.now().isAfter(end)) {
                break;
            }
            run(test);
            classes++;
        }
        out.println(classes + " of " + order.size() + " pure test classes, " + Math.min(classes, ofChanges)
                + " of them for changed sources; ./nephele test runs everything");
        out.println(passed + " passed, " + failed + " failed");
        return failed == 0 && passed > 0;
    }

    private void run(Path test) {
        launcher.execute(
                LauncherDiscoveryRequestBuilder.request()
                        .selectors(selectClass(className(test)))
                        .build(),
                listener);
        TestExecutionSummary summary = listener.getSummary();
        passed += summary.getTestsSucceededCount();
        failed += summary.getTotalFailureCount();
        if (summary.getTotalFailureCount() > 0) {
            summary.printFailuresTo(new PrintWriter(out, true), 12);
        }
    }

    private static List<Path> pureTests() throws IOException {
        try (Stream<Path> files = Files.walk(SOURCES)) {
            return files.filter(file -> file.toString().endsWith("Test.java"))
                    .filter(file -> NOT_PURE.stream().noneMatch(file.toString()::endsWith))
                    .sorted()
                    .toList();
        }
    }

    /** Returns the simple names of classes whose sources differ from the last commit; empty without git. */
    private static Set<String> changedNames() throws IOException, InterruptedException {
        Set<String> names = new LinkedHashSet<>();
        for (String line : git("status", "--porcelain", "--untracked-files=all")) {
            String file = line.substring(line.lastIndexOf('/') + 1);
            if (file.endsWith(".java")) {
                names.add(file.substring(0, file.length() - ".java".length()));
            }
        }
        return names;
    }

    private static List<String> git(String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("git"));
        command.addAll(List.of(arguments));
        Process process;
        try {
            process = new ProcessBuilder(command)
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
        } catch (IOException noGit) {
            return List.of();
        }
        List<String> lines = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)
                .lines()
                .toList();
        return process.waitFor() == 0 ? lines : List.of();
    }

    /** Returns the changed tests, and those that mention a changed class. */
    private static Set<Path> ofChanges(List<Path> tests, Set<String> changed) throws IOException {
        Set<Path> found = new LinkedHashSet<>();
        for (Path test : tests) {
            String name = test.getFileName().toString().replace(".java", "");
            boolean isOf = changed.contains(name)
                    || name.endsWith("Test") && changed.contains(name.substring(0, name.length() - 4));
            if (isOf || !changed.isEmpty() && mentionsOne(Files.readString(test), changed)) {
                found.add(test);
            }
        }
        return found;
    }

    private static boolean mentionsOne(String source, Set<String> names) {
        for (String word : source.split("\\W+")) {
            if (names.contains(word)) {
                return true;
            }
        }
        return false;
    }

    /** Returns all tests: the fastest of each package, then the second fastest of each, and so on. */
    private static List<Path> fastestOfEachPackage(List<Path> tests) throws IOException {
        Map<String, Double> seconds = secondsOfTheLastRun();
        Map<Path, Double> costs = new HashMap<>();
        for (Path test : tests) {
            costs.put(test, seconds.getOrDefault(className(test), Files.size(test) / LETTERS_A_SECOND));
        }
        List<Path> byCost = new ArrayList<>(tests);
        byCost.sort(Comparator.comparing(costs::get));
        Map<Path, Integer> before = new HashMap<>();
        Map<Path, Integer> ranks = new HashMap<>();
        for (Path test : byCost) {
            ranks.put(test, before.merge(test.getParent(), 1, Integer::sum));
        }
        byCost.sort(Comparator.comparing(ranks::get));
        return byCost;
    }

    private static Map<String, Double> secondsOfTheLastRun() throws IOException {
        Map<String, Double> seconds = new HashMap<>();
        if (Files.isDirectory(REPORTS)) {
            try (Stream<Path> reports = Files.list(REPORTS)) {
                for (Path report :
                        reports.filter(file -> file.toString().endsWith(".xml")).toList()) {
                    TEST_CASE
                            .matcher(Files.readString(report))
                            .results()
                            .forEach(test ->
                                    seconds.merge(test.group(1), Double.parseDouble(test.group(2)), Double::sum));
                }
            }
        }
        return seconds;
    }

    private static String className(Path test) {
        return SOURCES.relativize(test)
                .toString()
                .replace(".java", "")
                .replace(test.getFileSystem().getSeparator(), ".");
    }
}
