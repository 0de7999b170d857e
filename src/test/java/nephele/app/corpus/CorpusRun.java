package nephele.app.corpus;

import com.sun.management.OperatingSystemMXBean;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.app.command.CommandLineFront;
import nephele.app.command.Commands;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;

/** Checks level files and shows the accepted ones; runs in its own process, to bound its memory. */
final class CorpusRun {
    private static final double MOST_CPU_SECONDS = 10;

    private final Path folder;
    private final OperatingSystemMXBean process = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    private CorpusRun(Path folder) {
        this.folder = folder;
    }

    /**
     * Prints a line for each rejected file and each failure, and on the error stream the costs of each file.
     *
     * @param files level files; without any, the odd levels are written into the working directory
     */
    public static void main(String[] files) throws IOException {
        var run = new CorpusRun(Files.createDirectories(Path.of("shown")).toAbsolutePath());
        Files.writeString(run.folder.resolve("second.json"), standing(120));
        Files.writeString(run.folder.resolve("moment.json"), standing(1));
        for (String file : files.length > 0 ? List.of(files) : OddLevels.write(Path.of(""))) {
            run.show(file).forEach(System.out::println);
        }
        System.exit(0);
    }

    private static String standing(int ticks) {
        return "{\"format\": \"nephele-replay\", \"version\": 1, \"level\": \"any\", \"inputs\": [{\"ticks\": " + ticks
                + "}]}";
    }

    /** Returns the lines of one file: that it is rejected, and any failure of the commands run on it. */
    private List<String> show(String file) {
        List<String> told = new ArrayList<>();
        long before = process.getProcessCpuTime();
        var err = new ByteArrayOutputStream();
        var checked = command(err, "check", file);
        double checkSeconds = secondsSince(before);
        boolean accepted = checked == ExitCode.DONE;
        if (!accepted && checked != ExitCode.INPUT || err.size() > 0) {
            told.add(file + ": check ends with " + checked + ": " + err.toString(StandardCharsets.UTF_8));
        }
        if (checked == ExitCode.INPUT) {
            told.add(file + ": refused");
        }
        if (checkSeconds > MOST_CPU_SECONDS) {
            told.add(file + ": check takes " + checkSeconds + " CPU-s");
        }
        System.err.println(String.format(Locale.ROOT, "%6.2f %s check", checkSeconds, file));
        if (accepted) {
            String picture = folder.resolve("picture.png").toString();
            expectDone(told, file, "render", file, "--out", picture, "--size", "64x36", "--quality", "low");
            expectDone(told, file, "simulate", file, "--replay", replay("second"), "--every", "120");
            expectDone(told, file, "play", file, "--replay", replay("moment"), "--size", "64x36", "--quality", "low");
        }
        return told;
    }

    private String replay(String name) {
        return folder.resolve(name + ".json").toString();
    }

    private void expectDone(List<String> told, String file, String... words) {
        var err = new ByteArrayOutputStream();
        long before = process.getProcessCpuTime();
        var exitCode = command(err, words);
        double seconds = secondsSince(before);
        System.err.println(String.format(Locale.ROOT, "%6.2f %s %s", seconds, file, words[0]));
        if (exitCode != ExitCode.DONE) {
            told.add(file + ": " + words[0] + " ends with " + exitCode + ": " + err.toString(StandardCharsets.UTF_8));
        }
        if (seconds > MOST_CPU_SECONDS) {
            told.add(file + ": " + words[0] + " takes " + seconds + " CPU-s");
        }
    }

    private static ExitCode command(ByteArrayOutputStream err, String... words) {
        var out = new PrintStream(new ByteArrayOutputStream(), false, StandardCharsets.UTF_8);
        var terminal = new Terminal(out, new PrintStream(err, true, StandardCharsets.UTF_8));
        return new CommandLineFront(terminal, Commands.ALL).run(words);
    }

    private double secondsSince(long before) {
        return (process.getProcessCpuTime() - before) / 1e9;
    }
}
