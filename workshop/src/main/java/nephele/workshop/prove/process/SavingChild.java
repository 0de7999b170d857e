package nephele.workshop.prove.process;

import java.io.IOException;
import java.nio.file.Path;

/** A process that saves one generation of a file after another until it is killed. */
final class SavingChild {
    /** A limit at which the process ends by itself, in case its parent has ended without killing it. */
    private static final int MOST_SAVES = 5_000;

    private SavingChild() {}

    /** Written when a save begins; {@link #ENDED} when it has ended. */
    static final char BEGUN = '(';

    static final char ENDED = ')';

    /**
     * Writes when each save begins and ends.
     *
     * @param arguments the {@link SavedFile}'s name and the file
     */
    public static void main(String[] arguments) throws IOException {
        SavedFile kind = SavedFile.valueOf(arguments[0]);
        Path file = Path.of(arguments[1]);
        for (int generation = 1; generation <= MOST_SAVES; generation++) {
            tell(BEGUN);
            kind.save(file, generation);
            tell(ENDED);
            if (System.out.checkError()) {
                return;
            }
        }
    }

    private static void tell(char what) {
        System.out.write(what);
        System.out.flush();
    }
}
