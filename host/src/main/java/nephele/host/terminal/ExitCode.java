package nephele.host.terminal;

/** The exit codes of the process. */
public enum ExitCode {
    DONE(0),
    /**
     * The input has errors; the message names file and path. A crash, which is reported to a file, has this code too.
     */
    INPUT(1),
    USAGE(2),
    /** The environment lacks something; the message says what and how to get it. */
    ENVIRONMENT(3);

    private final int number;

    ExitCode(int number) {
        this.number = number;
    }

    /** Returns the number that the process exits with. */
    public int number() {
        return number;
    }
}
