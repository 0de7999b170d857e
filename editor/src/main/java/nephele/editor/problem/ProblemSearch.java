package nephele.editor.problem;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.LevelRule.Stage;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.rule.LevelRules;

/**
 * Finds the problems of a level after each of its edits. What follows from unchanged records is kept from the search
 * before: shapes, models and the verdicts on files; after a file has changed, start a new one. Used by one thread at a
 * time, any thread.
 */
public final class ProblemSearch {
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
            return isOver.getAsBoolean() ? Optional.empty() : Optional.of(shown(level, statics, found));
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

    /** Reads files only if a record that names one has changed, or what their models are compared with. */
    private List<Problem> ofFiles(Level level, BooleanSupplier isOver) {
        List<Object> named = new ArrayList<>(List.of(level.materials(), level.environment(), level.models()));
        if (!level.models().isEmpty()) {
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
        } catch (IllegalArgumentException | AssetException toldByARule) {
            return null;
        }
    }

    private static List<LevelProblem> shown(Level level, StaticShapes statics, List<Problem> found) {
        ProblemFixes fixes = new ProblemFixes(level, statics);
        List<LevelProblem> shown = new ArrayList<>();
        for (Problem.Severity severity : Problem.Severity.values()) {
            for (Problem problem : found) {
                if (problem.severity() == severity && isShown(problem)) {
                    shown.add(shown(level, problem, fixes));
                }
            }
        }
        shown.addAll(ProblemHints.of(level, statics));
        return ProblemKey.numbered(shown);
    }

    /** Leaves out the missing start, which is a hint here. */
    private static boolean isShown(Problem problem) {
        return problem.subject().topic() != Topic.NO_VIEWPOINT;
    }

    private static LevelProblem shown(Level level, Problem problem, ProblemFixes fixes) {
        EntityRef entity = EntityPath.of(level, problem.path())
                .map(path -> path.reference(level))
                .orElse(problem.path().startsWith("player") ? EntityRef.single("player") : null);
        return new LevelProblem(
                ProblemKey.of(level, problem),
                problem.isError() ? ProblemSeverity.ERROR : ProblemSeverity.WARNING,
                problem.path(),
                Words.same(problem.message()),
                ProblemMarks.of(level, problem),
                entity,
                fixes.of(problem));
    }
}
