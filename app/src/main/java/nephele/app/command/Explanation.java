package nephele.app.command;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileSystemException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.time.Instant;
import java.util.List;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.FileName;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.model.ModelFileException;
import nephele.engine.render.gl.GlUnavailableException;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.CrashReport;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;

/** A failure in plain words: the only place that maps exceptions to exit codes and messages for the user. */
record Explanation(ExitCode exitCode, String message, Throwable failure) {
    static Explanation of(Throwable failure, List<String> arguments) {
        if (failure instanceof CommandFailure known) {
            return new Explanation(known.exitCode(), known.getMessage(), failure);
        }
        if (failure instanceof LevelFormatException
                || failure instanceof AssetException
                || failure instanceof ModelFileException) {
            return new Explanation(ExitCode.INPUT, failure.getMessage(), failure);
        }
        if (failure instanceof GlUnavailableException) {
            return new Explanation(ExitCode.ENVIRONMENT, failure.getMessage(), failure);
        }
        if (failure instanceof UncheckedIOException wrapped) {
            return of(wrapped.getCause(), arguments);
        }
        if (failure instanceof NoSuchFileException missing) {
            return new Explanation(ExitCode.INPUT, missing.getFile() + ": no such file", failure);
        }
        if (failure instanceof FileSystemException refused) {
            var message = refused.getFile() + ": " + AtomicFile.reason(refused);
            return new Explanation(ExitCode.ENVIRONMENT, message, failure);
        }
        if (failure instanceof IOException failed) {
            return new Explanation(ExitCode.ENVIRONMENT, AtomicFile.reason(failed), failure);
        }
        if (failure instanceof InvalidPathException noPath) {
            var message = FileName.printable(noPath.getInput()) + ": " + FileName.objection(noPath.getInput());
            return new Explanation(ExitCode.INPUT, message, failure);
        }
        if (failure instanceof UnsatisfiedLinkError) {
            return new Explanation(ExitCode.ENVIRONMENT, withoutLibrary(failure), failure);
        }
        if (failure instanceof OutOfMemoryError) {
            return new Explanation(
                    ExitCode.ENVIRONMENT, "out of memory; give Java more, for example `java -Xmx4g -jar …`", failure);
        }
        return new Explanation(ExitCode.INPUT, crash(failure, arguments), failure);
    }

    ExitCode report(Terminal terminal, String command, boolean withStackTrace) {
        terminal.out().flush();
        boolean namesTheFile = failure instanceof LevelFormatException || failure instanceof ModelFileException;
        terminal.err().println(namesTheFile ? message : command + ": " + message);
        if (withStackTrace) {
            failure.printStackTrace(terminal.err());
        }
        return exitCode;
    }

    private static String withoutLibrary(Throwable failure) {
        return "a native library is missing: " + failure.getMessage()
                + "\nOn Debian or Ubuntu: apt-get install libegl1 libgl1 libgl1-mesa-dri";
    }

    private static String crash(Throwable crash, List<String> arguments) {
        try {
            var file = new CrashReport(arguments, Instant.now(), crash).write();
            return "this is a bug in Nephele, not in your input. Please report it with the file " + file;
        } catch (IOException unwritable) {
            return "this is a bug in Nephele, and the crash report can't be written: " + unwritable.getMessage()
                    + "\n`--verbose` shows it here.";
        }
    }
}
