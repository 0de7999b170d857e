package nephele.engine.level.json;

import java.util.List;
import java.util.stream.Collectors;
import nephele.engine.level.Problem;

/** Thrown for a file that is no level; the message has one line for each problem. */
public final class LevelFormatException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient List<Problem> problems;
    private final boolean damage;

    public LevelFormatException(String file, List<Problem> problems) {
        this(file, problems, false);
    }

    private LevelFormatException(String file, List<Problem> problems, boolean damage) {
        super(problems.stream().map(problem -> problem.line(file)).collect(Collectors.joining("\n")));
        this.problems = List.copyOf(problems);
        this.damage = damage;
    }

    /** Creates the exception for a file that cannot be read, or is no JSON document at all. */
    static LevelFormatException damage(String file, List<Problem> problems) {
        return new LevelFormatException(file, problems, true);
    }

    /** Returns all problems of the file. */
    public List<Problem> problems() {
        return problems;
    }

    /** Returns true if the file seems damaged rather than wrongly written, so that a backup may replace it. */
    public boolean isDamage() {
        return damage;
    }
}
