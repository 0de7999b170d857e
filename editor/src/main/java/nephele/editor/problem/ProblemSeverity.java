package nephele.editor.problem;

/** How much a problem matters; a HINT is no problem of {@code check}. */
public enum ProblemSeverity {
    ERROR,
    WARNING,
    HINT
}
