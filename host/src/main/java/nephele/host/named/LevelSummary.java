package nephele.host.named;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.Picture;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.rule.LevelRules;

/**
 * The name, aim, par and picture of a level for a list, and its problems.
 *
 * @param name the level's own; empty for none
 * @param par {@code null} for none
 * @param picture {@code null} for none
 * @param problems for which it cannot be played; empty for a good one
 */
public record LevelSummary(
        String name,
        String description,
        Map<Language, String> aim,
        Level.Par par,
        List<String> problems,
        Picture picture) {
    private static final LevelSummary NOTHING = new LevelSummary("", "", Map.of(), null, List.of(), null);

    public LevelSummary {
        problems = List.copyOf(problems);
    }

    /** Reads a level and checks it as {@link LevelName#open} does, and the files that it names; never fails. */
    public static LevelSummary checked(LevelName level) {
        return of(() -> {
            OpenedLevel opened = level.open();
            List<Problem> problems = new ArrayList<>(LevelRules.checkRecordsAndFiles(opened.level(), opened.assets()));
            problems.removeIf(problem -> !problem.isError());
            if (!problems.isEmpty()) {
                throw new LevelFormatException(opened.file(), problems);
            }
            return opened.level();
        });
    }

    /** Reads a level that the game brings, which is known to be good; never fails. */
    public static LevelSummary unchecked(LevelName level) {
        return of(() -> LevelFile.open(level.typed()).level());
    }

    private static LevelSummary of(Supplier<Level> level) {
        try {
            Level read = level.get();
            return new LevelSummary(read.name(), read.description(), read.aim(), read.par(), List.of(), null);
        } catch (LevelFormatException wrong) {
            return NOTHING.with(wrong.problems().stream()
                    .filter(Problem::isError)
                    .map(LevelSummary::line)
                    .toList());
        } catch (AssetException wrong) {
            return NOTHING.with(List.of(wrong.getMessage()));
        } catch (OutOfMemoryError tooLarge) {
            return NOTHING.with(List.of("does not fit into memory: make the level or its files smaller"));
        }
    }

    private LevelSummary with(List<String> others) {
        return new LevelSummary(name, description, aim, par, others, picture);
    }

    /** Returns this with the level's picture; {@code null} for none. */
    public LevelSummary with(Picture other) {
        return new LevelSummary(name, description, aim, par, problems, other);
    }

    /** Returns place and message; the list names the file. */
    private static String line(Problem problem) {
        return problem.path().equals("$") ? problem.message() : problem.path() + ": " + problem.message();
    }

    /** Returns true if the level can be played. */
    public boolean isGood() {
        return problems.isEmpty();
    }
}
