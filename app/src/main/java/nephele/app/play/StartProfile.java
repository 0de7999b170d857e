package nephele.app.play;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The times of the parts from the process's start to the first frame. */
public final class StartProfile {
    /** The index of the start time after the process name: field 22 of proc(5) stat. */
    private static final int START_FIELD = 19;

    private static final double CLOCK_TICKS_PER_SECOND = 100;

    private final long beganNanos = System.nanoTime();
    private final List<String> lines = new ArrayList<>();
    private long lastNanos = beganNanos;

    /** Ends the part since the last call. */
    public void done(String part) {
        long now = System.nanoTime();
        lines.add(line(part, (now - lastNanos) / 1e6));
        lastNanos = now;
    }

    /** Adds a part that ran in parallel to the others. */
    public void beside(String part, long nanos) {
        lines.add(line(part + " (beside)", nanos / 1e6));
    }

    /** Returns all parts, the total and the peak resident memory. */
    public List<String> report() {
        double jvmMs = sinceProcessStartMs() - (System.nanoTime() - beganNanos) / 1e6;
        var report = new ArrayList<String>();
        report.add(line("JVM", jvmMs));
        report.addAll(lines);
        report.add(line("total since JVM start", jvmMs + (lastNanos - beganNanos) / 1e6));
        report.add("peak RSS: " + peakResident());
        return report;
    }

    /**
     * Returns the time since the process started: from proc(5), in clock ticks since boot, on Linux; elsewhere since
     * the JVM started.
     */
    private static double sinceProcessStartMs() {
        try {
            String stat = Files.readString(Path.of("/proc/self/stat"));
            String[] afterName = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
            double startedSeconds = Long.parseLong(afterName[START_FIELD]) / CLOCK_TICKS_PER_SECOND;
            String uptime = Files.readString(Path.of("/proc/uptime"));
            return (Double.parseDouble(uptime.split(" ")[0]) - startedSeconds) * 1000;
        } catch (IOException notLinux) {
            return System.currentTimeMillis()
                    - ManagementFactory.getRuntimeMXBean().getStartTime();
        }
    }

    private static String line(String part, double ms) {
        return String.format(Locale.ROOT, "%s: %.0f ms", part, ms);
    }

    /** Returns the high-water mark of resident memory, which Linux provides. */
    private static String peakResident() {
        try (var status = Files.lines(Path.of("/proc/self/status"))) {
            return status.filter(line -> line.startsWith("VmHWM:"))
                    .findFirst()
                    .map(line -> Long.parseLong(line.replaceAll("[^0-9]", "")) * 1024 / 1_000_000 + " MB")
                    .orElse("unknown");
        } catch (IOException notLinux) {
            return "unknown";
        }
    }
}
