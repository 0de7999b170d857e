package nephele.editor.problem;

/** The severity of a problem; {@code check} does not report a HINT. */
public enum ProblemSeverity {
    ERROR,
    WARNING,
    HINT
}
