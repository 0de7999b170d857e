package nephele.engine.level.layout;

import java.util.function.Consumer;
import nephele.engine.level.Problem;

/** Passes the first problems of a rule on; a heap of solids in one place has millions. */
public final class FirstProblems {
    public static final int MOST = 50;

    private final Consumer<Problem> report;
    private final String section;
    private int count;

    /**
     * Starts counting.
     *
     * @param section path of the problem that says that there are more
     */
    public FirstProblems(String section, Consumer<Problem> report) {
        this.section = section;
        this.report = report;
    }

    /** Returns true if no more problems are wanted. */
    public boolean isFull() {
        return count > MOST;
    }

    /** Passes a problem on, or says once that there are more. */
    public void accept(Problem problem) {
        count++;
        if (count <= MOST) {
            report.accept(problem);
        } else if (count == MOST + 1) {
            report.accept(Problem.warning(section, "there are more like the last one; these are the first " + MOST));
        }
    }
}
