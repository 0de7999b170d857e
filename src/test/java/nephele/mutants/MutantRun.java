package nephele.mutants;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/** Puts a mutant before everything else on the class path of a new Java process, which runs the one test class. */
final class MutantRun {
    /** What became of a mutant; {@code evidence} is the first assertion that failed, or why none did. */
    record Verdict(Mutant mutant, boolean killed, String evidence) {}

    private static final int TESTS_FAILED = 1;

    private final Path folder;

    MutantRun(Path folder) {
        this.folder = folder;
    }

    Verdict judge(Mutant mutant) throws IOException, InterruptedException {
        Path override = Files.createDirectories(folder.resolve(mutant.name().replaceAll("\\W+", "-")));
        place(mutant, override);
        Path log = override.resolve("log.txt");
        int exit = start(override, testClass(mutant.killer()), log).waitFor();
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

    private static String testClass(String simpleName) throws IOException {
        try (Stream<Path> tests = Files.walk(Path.of("src/test/java"))) {
            Path file = tests.filter(p -> p.endsWith(simpleName + ".java"))
                    .findFirst()
                    .orElseThrow(() -> new IOException("there is no test " + simpleName));
            String relative = Path.of("src/test/java").relativize(file).toString();
            return relative.replace(".java", "").replace('/', '.').replace('\\', '.');
        }
    }

    private static Process start(Path override, String testClass, Path log) throws IOException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        for (String argument : ManagementFactory.getRuntimeMXBean().getInputArguments()) {
            if (argument.startsWith("-D") || argument.startsWith("--add")) {
                command.add(argument);
            }
        }
        String classPath = override + System.getProperty("path.separator") + System.getProperty("java.class.path");
        command.addAll(List.of("-Xmx1g", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-cp", classPath));
        command.addAll(List.of("org.junit.platform.console.ConsoleLauncher", "execute", "--disable-banner"));
        command.addAll(List.of("--details=summary", "--fail-if-no-tests", "--select-class=" + testClass));
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
