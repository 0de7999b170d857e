package nephele.engine.level;

import java.util.List;
import java.util.stream.Collectors;

/** A file that is no level: all that is wrong with it, one line each in the message. */
public final class LevelFormatException extends RuntimeException {
    private final String file;
    private final transient List<Problem> problems;

    public LevelFormatException(String file, List<Problem> problems) {
        super(problems.stream().map(problem -> problem.line(file)).collect(Collectors.joining("\n")));
        this.file = file;
        this.problems = List.copyOf(problems);
    }

    public String file() {
        return file;
    }

    public List<Problem> problems() {
        return problems;
    }
}
