package nephele.mutants;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/** Runs one test class in a new Java process that has a mutant first on its class path. */
final class MutantRun {
    /** The result for a mutant; {@code evidence} is the first failed assertion, or the reason why none failed. */
    record Verdict(Mutant mutant, boolean killed, String evidence) {}

    private static final int TESTS_FAILED = 1;

    /** The limit for one run, as a fault may make a loop endless; no test of a mutant needs a tenth of this. */
    private static final long MOST_MINUTES = 10;

    private static final Path TESTS = Path.of("src/test/java");

    private final Path folder;

    MutantRun(Path folder) {
        this.folder = folder;
    }

    /**
     * Runs the test classes of these mutants without any fault: a test that fails anyway would kill every mutant.
     *
     * @throws IOException if one fails
     */
    void requireGreen(List<Mutant> mutants) throws IOException, InterruptedException {
        Set<String> tests = new TreeSet<>();
        for (Mutant mutant : mutants) {
            tests.add(testClass(mutant.killer()));
        }
        Path log = folder.resolve("without-a-fault.txt");
        if (run(List.of(), tests, log) != 0) {
            String failure = firstFailure(Files.readString(log)).orElse("see " + log);
            throw new IOException("a test fails without any fault: " + failure);
        }
    }

    Verdict judge(Mutant mutant) throws IOException, InterruptedException {
        Path override = Files.createDirectories(folder.resolve(mutant.name().replaceAll("\\W+", "-")));
        place(mutant, override);
        Path log = override.resolve("log.txt");
        int exit = run(List.of(override.toString()), Set.of(testClass(mutant.killer())), log);
        String report = Files.readString(log);
        Optional<String> failure = firstFailure(report);
        if (exit == TESTS_FAILED && failure.isPresent() && !report.contains("GlException")) {
            return new Verdict(mutant, true, failure.get());
        }
        return new Verdict(mutant, false, exit == 0 ? "every test passed" : "no test could judge, see " + log);
    }

    private static void place(Mutant mutant, Path override) throws IOException {
        String mutated = mutant.mutated();
        if (!mutant.isJava()) {
            Path target = override.resolve(mutant.resource());
            Files.createDirectories(target.getParent());
            Files.writeString(target, mutated);
            return;
        }
        Path source = override.resolve("source").resolve(mutant.resource());
        Files.createDirectories(source.getParent());
        Files.writeString(source, mutated);
        String classPath = System.getProperty("java.class.path");
        int failed = ToolProvider.getSystemJavaCompiler()
                .run(
                        null,
                        null,
                        null,
                        "-proc:none",
                        "-nowarn",
                        "-encoding",
                        "UTF-8",
                        "--release",
                        "17",
                        "-cp",
                        classPath,
                        "-d",
                        override.toString(),
                        source.toString());
        if (failed != 0) {
            throw new IOException(mutant.name() + ": the mutant does not compile; adapt it");
        }
    }

    /**
     * Returns the class name of a test.
     *
     * @param killer simple name of a test class, preceded by as many folders as make it unique: {@code sim/WalkTest}
     * @throws IOException unless exactly one class matches
     */
    static String testClass(String killer) throws IOException {
        try (Stream<Path> tests = Files.walk(TESTS)) {
            List<Path> files = tests.filter(p -> p.endsWith(killer + ".java")).toList();
            if (files.size() != 1) {
                throw new IOException("there are " + files.size() + " tests " + killer + " under " + TESTS);
            }
            String relative = TESTS.relativize(files.get(0)).toString();
            return relative.replace(".java", "").replace('/', '.').replace('\\', '.');
        }
    }

    private static int run(List<String> before, Set<String> testClasses, Path log)
            throws IOException, InterruptedException {
        Process process = start(before, testClasses, log);
        if (!process.waitFor(MOST_MINUTES, TimeUnit.MINUTES)) {
            process.destroyForcibly().waitFor();
        }
        return process.exitValue();
    }

    private static Process start(List<String> before, Set<String> testClasses, Path log) throws IOException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        for (String argument : ManagementFactory.getRuntimeMXBean().getInputArguments()) {
            if (argument.startsWith("-D") || argument.startsWith("--add")) {
                command.add(argument);
            }
        }
        List<String> classPath = new ArrayList<>(before);
        classPath.add(System.getProperty("java.class.path"));
        command.addAll(List.of("-Xmx1g", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC"));
        command.addAll(List.of("-cp", String.join(System.getProperty("path.separator"), classPath)));
        command.addAll(List.of("org.junit.platform.console.ConsoleLauncher", "execute", "--disable-banner"));
        command.addAll(List.of("--details=summary", "--fail-if-no-tests"));
        testClasses.forEach(name -> command.add("--select-class=" + name));
        return new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(log.toFile())
                .start();
    }

    private static Optional<String> firstFailure(String report) {
        String test = null;
        for (String line : report.lines().toList()) {
            if (line.strip().startsWith("JUnit Jupiter:")) {
                test = line.strip().replace("JUnit Jupiter:", "");
            } else if (line.strip().startsWith("=>") && test != null) {
                return Optional.of(test + " " + line.strip());
            }
        }
        return Optional.empty();
    }
}
