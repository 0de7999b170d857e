package nephele.editor.problem;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.layout.LayoutRules;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.PlacedRule;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.rule.LevelRule;
import nephele.engine.level.rule.LevelRules;
import nephele.engine.sim.WorldRules;

/**
 * Finds the problems of a level after each of its edits. What follows from unchanged records is kept from the search
 * before: shapes, models and the verdicts on files; after a file has changed, start a new one. Used by one thread at a
 * time, any thread.
 */
public final class ProblemSearch {
    private static final List<LevelRule> OF_FILES =
            LevelRules.ALL.subList(LevelRules.STRUCTURE.size(), LevelRules.ALL.size());

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
        Cancellable rules = new Cancellable(isCancelled, new ArrayList<>());
        boolean isDone = rules.structure(level, assets) && filesChecked(level, rules);
        if (!isDone) {
            return Optional.empty();
        }
        StaticShapes statics = derived(level);
        boolean isSound = rules.found().stream().noneMatch(Problem::isError);
        if (statics != null && !rules.placed(isSound ? WorldRules.PLACED : LayoutRules.ALL, level, statics)) {
            return Optional.empty();
        }
        return rules.isOver() ? Optional.empty() : Optional.of(shown(level, statics, rules.found()));
    }

    private record Cancellable(BooleanSupplier isCancelled, List<Problem> found) {
        boolean isOver() {
            return isCancelled.getAsBoolean() || Thread.currentThread().isInterrupted();
        }

        boolean structure(Level level, AssetSource assets) {
            for (LevelRule rule : LevelRules.STRUCTURE) {
                if (isOver()) {
                    return false;
                }
                rule.check(level, assets, found::add);
            }
            return true;
        }

        boolean placed(List<PlacedRule> rules, Level level, StaticShapes statics) {
            for (PlacedRule rule : rules) {
                if (isOver()) {
                    return false;
                }
                rule.check(level, statics, found::add);
            }
            return true;
        }
    }

    /** Reads files only if a record that names one has changed, or what their models are compared with. */
    private boolean filesChecked(Level level, Cancellable rules) {
        List<Object> named = new ArrayList<>(List.of(level.materials(), level.environment(), level.models()));
        if (!level.models().isEmpty()) {
            named.addAll(List.of(level.solids(), level.portals(), Optional.ofNullable(level.player())));
        }
        if (!named.equals(namedFiles)) {
            List<Problem> problems = new ArrayList<>();
            for (LevelRule rule : OF_FILES) {
                if (rules.isOver()) {
                    return false;
                }
                rule.check(level, assets, problems::add);
            }
            ofFiles = List.copyOf(problems);
            namedFiles = named;
        }
        rules.found().addAll(ofFiles);
        return true;
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
