package nephele.host.terminal;

/** A command cannot do what was requested. The message tells the user what is wrong, where, and what to do. */
public final class CommandFailure extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final ExitCode exitCode;

    private CommandFailure(ExitCode exitCode, String message, Throwable cause) {
        super(message, cause);
        this.exitCode = exitCode;
    }

    /** Returns a failure due to the input; exit code {@link ExitCode#INPUT}. */
    public static CommandFailure input(String message) {
        return new CommandFailure(ExitCode.INPUT, message, null);
    }

    /** Returns a failure due to wrong arguments; exit code {@link ExitCode#USAGE}. */
    public static CommandFailure usage(String message) {
        return new CommandFailure(ExitCode.USAGE, message, null);
    }

    /** Returns a failure due to the environment; exit code {@link ExitCode#ENVIRONMENT}. */
    public static CommandFailure environment(String message) {
        return new CommandFailure(ExitCode.ENVIRONMENT, message, null);
    }

    /** Returns a failure due to the environment, with its cause; exit code {@link ExitCode#ENVIRONMENT}. */
    public static CommandFailure environment(String message, Throwable cause) {
        return new CommandFailure(ExitCode.ENVIRONMENT, message, cause);
    }

    /** Returns the exit code of the process. */
    public ExitCode exitCode() {
        return exitCode;
    }
}
