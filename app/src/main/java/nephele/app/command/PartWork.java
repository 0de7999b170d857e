package nephele.app.command;

import java.io.IOException;
import nephele.engine.asset.AtomicFile;
import nephele.engine.reference.tile.PartFileException;
import nephele.engine.terminal.CommandFailure;

/** Work with part files, whose failures tell the user which file and why. */
@FunctionalInterface
interface PartWork<T> {
    T run() throws IOException;

    /** Returns the result of the work. */
    static <T> T done(PartWork<T> work) {
        try {
            return work.run();
        } catch (PartFileException unusable) {
            throw CommandFailure.input(unusable.getMessage());
        } catch (IOException failure) {
            throw CommandFailure.environment(
                    failure.getMessage() == null ? AtomicFile.reason(failure) : failure.getMessage(), failure);
        }
    }
}
