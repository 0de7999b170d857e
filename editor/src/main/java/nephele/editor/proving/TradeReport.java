package nephele.editor.proving;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import nephele.editor.text.Words;

/**
 * The report on speed against accuracy of the open level's file, made by a process of its own. A report that was stopped
 * goes on where it was.
 */
public final class TradeReport {
    private static final String PAGE = "index.html";

    private final ProvingSubject subject;
    private final Supplier<ProvingThreads> threads;
    private BiFunction<Path, Path, List<String>> commandLine = (level, out) -> List.of();
    private Process process;
    private Path page;

    TradeReport(ProvingSubject subject, Supplier<ProvingThreads> threads) {
        this.subject = subject;
        this.threads = threads;
    }

    /**
     * Sets the program; without one, no report can be made.
     *
     * @param program returns the command line for a level's file and the folder that receives {@code index.html}; the
     *     program prints its progress as lines
     */
    public void madeBy(BiFunction<Path, Path, List<String>> program) {
        commandLine = program;
    }

    /** Returns the usual folder of a level's report. */
    public static Path folder(Path level) {
        String name = level.getFileName().toString().replaceFirst("\\.json$", "");
        return Path.of(System.getProperty("java.io.tmpdir"), "nephele-trade", name);
    }

    public boolean isRunning() {
        return process != null && process.isAlive();
    }

    /** Returns the finished page; empty if there is none. */
    public Optional<Path> page() {
        return Optional.ofNullable(page);
    }

    /**
     * Starts the program.
     *
     * @param finished called when the page is there
     */
    public void start(Path level, Path out, Runnable finished) {
        page = null;
        List<String> words = commandLine.apply(level.toAbsolutePath(), out.toAbsolutePath());
        try {
            Files.createDirectories(out);
            process = new ProcessBuilder(words).redirectErrorStream(true).start();
            process.getOutputStream().close();
        } catch (IOException | IndexOutOfBoundsException missing) {
            failed(String.valueOf(missing.getMessage()));
            return;
        }
        subject.status(ProvingText.TRADE_STARTED.words());
        Process started = process;
        threads.get().work().execute(() -> follow(started, out.resolve(PAGE), finished));
    }

    /** Stops the program, with the processes that it has started. */
    public void stop() {
        if (isRunning()) {
            process.descendants().forEach(ProcessHandle::destroy);
            process.destroy();
            process = null;
            subject.status(ProvingText.TRADE_STOPPED.words());
        }
    }

    private void follow(Process started, Path result, Runnable finished) {
        String last = lines(started, started.getInputStream());
        int code = exit(started);
        threads.get().session().execute(() -> {
            if (process != started) {
                return;
            }
            if (code == 0 && Files.isRegularFile(result)) {
                page = result;
                subject.status(ProvingText.TRADE_DONE.with(result));
                finished.run();
            } else {
                failed(last.isEmpty() ? "exit code " + code : last);
            }
        });
    }

    /** Shows each line as progress, and returns the last one. */
    private String lines(Process started, InputStream output) {
        String last = "";
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(output, StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                last = line.isBlank() ? last : line.strip();
                Words words = ProvingText.TRADE_PROGRESS.with(last);
                threads.get().session().execute(() -> {
                    if (process == started) {
                        subject.status(words);
                    }
                });
            }
        } catch (IOException ended) {
            return last;
        }
        return last;
    }

    private static int exit(Process started) {
        try {
            return started.waitFor();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            started.destroy();
            return -1;
        }
    }

    private void failed(String reason) {
        process = null;
        subject.status(ProvingText.TRADE_FAILED.with(reason));
    }
}
