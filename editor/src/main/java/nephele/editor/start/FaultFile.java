package nephele.editor.start;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.function.Consumer;
import nephele.editor.text.Words;
import nephele.engine.asset.AtomicFile;
import nephele.host.terminal.CrashReport;

/**
 * Writes a fault of the program to a file and tells of it in one line. The event loop goes on after a fault, and the
 * edits before it are in the document and its journal.
 */
final class FaultFile implements Thread.UncaughtExceptionHandler {
    private static final Words WRITTEN = Words.of(
            "The editor has a fault; your work is kept, but save it. What happened is in %s",
            "O editor tem um defeito; seu trabalho está guardado, mas salve-o. O que houve está em %s",
            "O editor tem um defeito; o teu trabalho está guardado, mas grava-o. O que houve está em %s");
    private static final Words NOT_WRITTEN = Words.of(
            "The editor has a fault; your work is kept, but save it: %s",
            "O editor tem um defeito; seu trabalho está guardado, mas salve-o: %s",
            "O editor tem um defeito; o teu trabalho está guardado, mas grava-o: %s");

    private final Path file;
    private final Consumer<Words> tell;

    /** @param tell called on the thread of the fault */
    FaultFile(Path file, Consumer<Words> tell) {
        this.file = file;
        this.tell = tell;
    }

    @Override
    public void uncaughtException(Thread thread, Throwable fault) {
        var report = new CrashReport(List.of("edit", "thread " + thread.getName()), Instant.now(), fault);
        try {
            AtomicFile.write(file, report.text().getBytes(StandardCharsets.UTF_8));
            tell.accept(WRITTEN.with(file));
        } catch (IOException noPlace) {
            tell.accept(NOT_WRITTEN.with(fault.toString()));
        }
    }
}
