package nephele.editor.problem;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import nephele.editor.record.EntityRef;
import nephele.editor.record.RecordKind;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Exit;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.json.WordFormats;
import nephele.engine.level.layout.Leak;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.LevelRule.Stage;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.rule.LevelRules;

/**
 * Finds the problems of a level after each of its edits. What follows from unchanged records is kept from the search
 * before: shapes, models and the verdicts on files; after a file has changed, start a new one. Used by one thread at a
 * time, any thread.
 */
public final class ProblemSearch {
    private static final Vec3 BESIDE_START = new Vec3(0, 0, -4);

    private final AssetSource assets;
    private PlacedLevel placed;
    private List<Object> namedFiles = List.of();
    private List<Problem> ofFiles = List.of();

    /** Creates a search without anything known. */
    public ProblemSearch(AssetSource assets) {
        this.assets = assets;
    }

    /** Returns the problems and hints of a level: errors, then warnings, then hints, hidden ones included. */
    public static List<LevelProblem> of(Level level, AssetSource assets) {
        return new ProblemSearch(assets).find(level, () -> false).orElseThrow();
    }

    /**
     * Returns the problems and hints of a level, as {@link #of}.
     *
     * @param isCancelled asked between rules; an interrupt of the thread cancels, too
     * @return empty if cancelled
     */
    public Optional<List<LevelProblem>> find(Level level, BooleanSupplier isCancelled) {
        BooleanSupplier isOver =
                () -> isCancelled.getAsBoolean() || Thread.currentThread().isInterrupted();
        try {
            List<Problem> found = apply(LevelRules.of(Stage.RECORDS), level, null, isOver);
            found.addAll(ofFiles(level, isOver));
            StaticShapes statics = derived(level);
            if (statics != null) {
                boolean isSound = found.stream().noneMatch(Problem::isError);
                var rules = isSound ? LevelRules.of(Stage.LAYOUT, Stage.WORLD) : LevelRules.of(Stage.LAYOUT);
                found.addAll(apply(rules, level, statics, isOver));
            }
            return isOver.getAsBoolean() ? Optional.empty() : Optional.of(listed(level, statics, found));
        } catch (CancellationException cancelled) {
            return Optional.empty();
        }
    }

    private List<Problem> apply(List<LevelRule> rules, Level level, StaticShapes statics, BooleanSupplier isOver) {
        List<Problem> problems = new ArrayList<>();
        for (LevelRule rule : rules) {
            if (isOver.getAsBoolean()) {
                throw new CancellationException();
            }
            rule.check().apply(level, assets, statics, problems::add);
        }
        return problems;
    }

    /** Reads files only if a record that names one has changed, or what models and billboards are compared with. */
    private List<Problem> ofFiles(Level level, BooleanSupplier isOver) {
        List<Object> named = new ArrayList<>(
                List.of(level.materials(), level.environment(), level.models(), level.terrains(), level.billboards()));
        if (!level.models().isEmpty() || !level.billboards().isEmpty()) {
            named.addAll(List.of(level.solids(), level.portals(), Optional.ofNullable(level.player())));
        }
        if (!named.equals(namedFiles)) {
            ofFiles = List.copyOf(apply(LevelRules.of(Stage.FILES), level, null, isOver));
            namedFiles = named;
        }
        return ofFiles;
    }

    /** Returns the level's shapes; {@code null} if a record keeps them from being derived. */
    private StaticShapes derived(Level level) {
        try {
            placed = placed == null ? PlacedLevel.of(level, assets) : placed.edited(level);
            return placed.statics();
        } catch (IllegalArgumentException | AssetException reportedByARule) {
            return null;
        }
    }

    private static List<LevelProblem> listed(Level level, StaticShapes statics, List<Problem> found) {
        ProblemFixes fixes = new ProblemFixes(level, statics);
        List<LevelProblem> listed = new ArrayList<>();
        found.stream()
                .filter(ProblemSearch::isListed)
                .sorted(Comparator.comparing(Problem::isError).reversed())
                .forEach(problem -> listed.add(listed(level, problem, fixes)));
        listed.addAll(of(level, statics));
        return numbered(listed);
    }

    /** Leaves out the missing start, which is a hint here. */
    private static boolean isListed(Problem problem) {
        return problem.subject().topic() != Topic.NO_VIEWPOINT;
    }

    private static LevelProblem listed(Level level, Problem problem, ProblemFixes fixes) {
        EntityRef entity = EntityPath.of(level, problem.path())
                .map(path -> path.reference(level))
                .orElse(problem.path().startsWith("player") ? EntityRef.single("player") : null);
        return new LevelProblem(
                of(level, problem),
                problem.isError() ? LevelProblem.Severity.ERROR : LevelProblem.Severity.WARNING,
                problem.path(),
                Words.same(problem.message()),
                ProblemMarks.of(level, problem),
                entity,
                fixes.of(problem));
    }

    /** @param statics {@code null} if they cannot be derived */
    private static List<LevelProblem> of(Level level, StaticShapes statics) {
        List<LevelProblem> hints = new ArrayList<>();
        if (level.player() == null) {
            LevelProblem.Fix fix = new LevelProblem.Fix(ProblemText.ADD_START.words(), now -> withStart(now, statics));
            hints.add(hint("player", ProblemText.NO_START, List.of(), statics == null ? List.of() : List.of(fix)));
        }
        if (level.exits().isEmpty()) {
            LevelProblem.Fix fix = new LevelProblem.Fix(ProblemText.ADD_EXIT.words(), now -> withExit(now, statics));
            hints.add(hint("exits", ProblemText.NO_EXIT, List.of(), statics == null ? List.of() : List.of(fix)));
        }
        boolean hasOutside =
                level.environment().sky() != null || level.environment().sun() != null;
        List<Vec3> line = hasOutside && statics != null ? Leak.line(level, statics) : List.of();
        if (!line.isEmpty()) {
            hints.add(hint("player.feet", ProblemText.OPEN_TO_OUTSIDE, line, List.of()));
        }
        return hints;
    }

    private static LevelProblem hint(String path, ProblemText text, List<Vec3> line, List<LevelProblem.Fix> fixes) {
        return new LevelProblem(
                WordFormats.Choice.word(text) + " " + path,
                LevelProblem.Severity.HINT,
                path,
                text.words(),
                ProblemMarks.line(line),
                line.isEmpty() ? null : EntityRef.single("player"),
                fixes);
    }

    private static Level withStart(Level now, StaticShapes statics) {
        Vec3 feet = new Floors(now, statics).middle();
        return now.player() != null
                ? now
                : RecordKind.with(now, "player", new PlayerStart(feet == null ? Vec3.ZERO : feet, 0, 0));
    }

    private static Level withExit(Level now, StaticShapes statics) {
        if (!now.exits().isEmpty()) {
            return now;
        }
        Vec3 from = now.player() == null ? Vec3.ZERO : now.player().feet();
        Vec3 far = new Floors(now, statics).farFrom(from);
        return now.withExits(List.of(new Exit("exit", far == null ? from.plus(BESIDE_START) : far, 1, 2)));
    }

    private static String of(Level level, Problem problem) {
        String place = EntityPath.of(level, problem.path())
                .map(path -> path.reference(level).text() + path.rest())
                .orElse(problem.path());
        return WordFormats.Choice.word(problem.subject().topic()) + " " + place;
    }

    /** Returns the problems with a number after each key that is there already. */
    private static List<LevelProblem> numbered(List<LevelProblem> problems) {
        Map<String, Integer> counts = new HashMap<>();
        List<LevelProblem> numbered = new ArrayList<>();
        for (LevelProblem problem : problems) {
            int count = counts.merge(problem.key(), 1, Integer::sum);
            numbered.add(count == 1 ? problem : problem.withKey(problem.key() + " #" + count));
        }
        return List.copyOf(numbered);
    }
}
