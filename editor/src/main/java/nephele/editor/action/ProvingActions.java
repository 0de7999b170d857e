package nephele.editor.action;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.document.Selection;
import nephele.editor.play.PlayText;
import nephele.editor.play.SolutionVerdict;
import nephele.editor.problem.LevelProblem;
import nephele.editor.proving.ComparedPictures;
import nephele.editor.proving.PixelExplanation;
import nephele.editor.proving.Proving;
import nephele.editor.proving.ProvingText;
import nephele.editor.proving.SolutionProof;
import nephele.editor.proving.TechniqueComparison;
import nephele.editor.proving.TradeReport;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.asset.AtomicFile;
import nephele.engine.level.CloudTechnique;
import nephele.host.compare.TechniquePair;
import nephele.host.compare.Wipe;

/** Proving the level: its problems, where portals fit, its solution, and what its pixels and its report say. */
public final class ProvingActions {
    /** Samples a pixel of the path-traced picture. */
    private static final int MOST_SAMPLES = 1 << 16;

    static final List<EditorAction> ALL = List.of(
            EditorAction.of(
                    "check",
                    Words.of("Check the Level", "Verificar a fase", "Verificar o nível"),
                    Menu.PROVE,
                    List.of("F7"),
                    ProvingActions::check),
            EditorAction.of(
                    "next-problem",
                    Words.of("Next Problem", "Próximo problema", "Problema seguinte"),
                    Menu.PROVE,
                    List.of("F8"),
                    call -> step(call.session(), 1)),
            EditorAction.of(
                    "previous-problem",
                    Words.of("Previous Problem", "Problema anterior", "Problema anterior"),
                    Menu.PROVE,
                    List.of("Shift+F8"),
                    call -> step(call.session(), -1)),
            EditorAction.of(
                            "heat",
                            Words.of("Where Portals Fit", "Onde cabem portais", "Onde cabem portais"),
                            Menu.PROVE,
                            List.of("F9"),
                            ProvingActions::heat)
                    .chosenWhen(session -> session.proving().heat().isVisible())
                    .taking("show"),
            EditorAction.of(
                    "check-solution",
                    Words.of("Check the Solution", "Verificar a solução", "Verificar a solução"),
                    Menu.PROVE,
                    List.of("Shift+F6"),
                    ProvingActions::checkSolution),
            EditorAction.of(
                            "path-trace",
                            Words.of(
                                    "Path-Traced Picture",
                                    "Imagem por traçado de raios",
                                    "Imagem por traçado de raios"),
                            Menu.PROVE,
                            List.of("F11"),
                            ProvingActions::pathTrace)
                    .chosenWhen(session -> session.proving().corner().isVisible())
                    .taking("show", "spp"),
            EditorAction.of(
                            "compare-techniques",
                            Words.of(
                                    "Compare Cloud Techniques",
                                    "Comparar técnicas de nuvem",
                                    "Comparar técnicas de nuvem"),
                            Menu.PROVE,
                            List.of(),
                            ProvingActions::compareTechniques)
                    .chosenWhen(session -> session.proving().techniques().isVisible())
                    .when(ProvingActions::hasCloud)
                    .taking("a", "b", "wipe", "show"),
            EditorAction.of(
                            "explain",
                            Words.of("Explain the Pixel…", "Explicar o pixel…", "Explicar o píxel…"),
                            Menu.PROVE,
                            List.of("Ctrl+E"),
                            ProvingActions::explain)
                    .taking("file", "at"),
            EditorAction.of(
                            "trade",
                            Words.of(
                                    "Speed against Accuracy…",
                                    "Velocidade contra precisão…",
                                    "Velocidade contra precisão…"),
                            Menu.PROVE,
                            List.of(),
                            ProvingActions::trade)
                    .chosenWhen(session -> session.proving().trade().isRunning())
                    .taking("out"));

    private ProvingActions() {}

    /** Selects the entity of a problem, and shows its place. */
    public static void choose(EditorSession session, LevelProblem problem) {
        Selection selection = problem.entity() == null ? Selection.NONE : Selection.of(problem.entity());
        session.document().select(selection);
        session.proving().problems().choose(problem);
    }

    private static void step(EditorSession session, int steps) {
        Optional<LevelProblem> problem = session.proving().problems().step(steps);
        problem.ifPresentOrElse(found -> choose(session, found), () -> session.status(ProvingText.NO_PROBLEMS.words()));
    }

    /** A script fails at the first error of the level. */
    private static void check(ActionCall call) throws EditorRefusal {
        List<LevelProblem> problems = call.session().proving().problems().listed();
        Words words = problems.isEmpty()
                ? ProvingText.NO_PROBLEMS.words()
                : ProvingText.PROBLEMS.with(
                        count(problems, LevelProblem.Severity.ERROR),
                        count(problems, LevelProblem.Severity.WARNING),
                        count(problems, LevelProblem.Severity.HINT));
        call.session().status(words);
        call.ui().show("problems");
        Optional<LevelProblem> error = problems.stream()
                .filter(problem -> problem.severity() == LevelProblem.Severity.ERROR)
                .findFirst();
        if (error.isPresent()) {
            throw new EditorRefusal(counted(words, error.get()));
        }
    }

    private static long count(List<LevelProblem> problems, LevelProblem.Severity severity) {
        return problems.stream()
                .filter(problem -> problem.severity() == severity)
                .count();
    }

    private static Words counted(Words count, LevelProblem first) {
        return Words.same("%s  –  %s: %s").with(count, first.path(), first.message());
    }

    private static boolean isWanted(ActionCall call, boolean now) throws EditorRefusal {
        return call.flag("show", !now);
    }

    private static void heat(ActionCall call) throws EditorRefusal {
        var heat = call.session().proving().heat();
        heat.show(isWanted(call, heat.isVisible()));
    }

    private static void pathTrace(ActionCall call) throws EditorRefusal {
        var corner = call.session().proving().corner();
        boolean isVisible = isWanted(call, corner.isVisible());
        if (call.text("spp").isPresent()) {
            corner.show(isVisible, call.whole("spp", 1, MOST_SAMPLES, 1));
        } else {
            corner.show(isVisible);
        }
    }

    private static boolean hasCloud(EditorSession session) {
        return !session.document().level().environment().clouds().isEmpty();
    }

    /** Compares in the inspector of the selected cloud, else of the first one. A script fails if nothing can be drawn. */
    private static void compareTechniques(ActionCall call) throws EditorRefusal {
        TechniqueComparison comparison = call.session().proving().techniques();
        boolean isAsked = call.text("a").isPresent()
                || call.text("b").isPresent()
                || call.text("wipe").isPresent();
        boolean shows = call.flag("show", isAsked || !comparison.isVisible());
        if (!shows) {
            comparison.hide();
            return;
        }
        if (comparison.cloud().isEmpty()) {
            String first = call.session()
                    .document()
                    .level()
                    .environment()
                    .clouds()
                    .get(0)
                    .id();
            call.session().document().select(Selection.of(new EntityRef(TechniqueComparison.CLOUDS, first)));
        }
        TechniquePair before = comparison.techniques();
        comparison.techniques(
                new TechniquePair(technique(call, "a", before.left()), technique(call, "b", before.right())));
        comparison.wipe(new Wipe(call.number("wipe", 0, 1, comparison.wipe().fraction())));
        comparison.show();
        String failure = comparison.pictures().map(ComparedPictures::failure).orElse(null);
        if (failure != null) {
            throw new EditorRefusal(Words.same(failure));
        }
    }

    private static CloudTechnique technique(ActionCall call, String name, CloudTechnique absent) throws EditorRefusal {
        try {
            return call.text(name).map(TechniquePair::technique).orElse(absent);
        } catch (IllegalArgumentException wrong) {
            throw new EditorRefusal(Words.same(name + ": " + wrong.getMessage()));
        }
    }

    private static Path file(ActionCall call, ProvingText because) throws EditorRefusal {
        Words reason = because.words();
        Words unsaved = ProvingText.UNSAVED.words();
        return call.session()
                .file()
                .path()
                .orElseThrow(() -> new EditorRefusal(Words.of(
                        String.format(unsaved.english(), reason.english()),
                        String.format(unsaved.brazilian(), reason.brazilian()),
                        String.format(unsaved.european(), reason.european()))));
    }

    /** A script fails if the solution does not reach the exit. */
    private static void checkSolution(ActionCall call) throws EditorRefusal {
        SolutionProof solution = call.session().proving().solution();
        solution.check(file(call, ProvingText.NEEDS_SOLUTION));
        Optional<String> failure = solution.failure();
        Optional<SolutionVerdict> verdict = solution.verdict();
        if (failure.isPresent()) {
            throw new EditorRefusal(Words.same(failure.get()));
        }
        if (verdict.isPresent() && !verdict.get().isSolved()) {
            throw new EditorRefusal(PlayText.of(verdict.get()));
        }
    }

    private static void explain(ActionCall call) throws EditorRefusal {
        Proving proving = call.session().proving();
        if (call.text("at").isPresent()) {
            proving.pointed(Optional.of(call.vector("at")));
        }
        if (!call.isGiven("file", "explanation")) {
            return;
        }
        List<String> failures = new ArrayList<>();
        Path file = call.file(Optional::empty).orElseThrow();
        proving.explain(found -> written(file, found).ifPresent(failures::add));
        if (!failures.isEmpty()) {
            throw new EditorRefusal(Words.same(failures.get(0)));
        }
    }

    /** Returns the failure, if any. */
    private static Optional<String> written(Path file, PixelExplanation explanation) {
        try {
            AtomicFile.write(file, (explanation.text() + "\n").getBytes(StandardCharsets.UTF_8));
            return Optional.empty();
        } catch (IOException problem) {
            return Optional.of(file + ": " + AtomicFile.reason(problem));
        }
    }

    private static void trade(ActionCall call) throws EditorRefusal {
        TradeReport trade = call.session().proving().trade();
        if (trade.isRunning()) {
            trade.stop();
            return;
        }
        Path level = file(call, ProvingText.NEEDS_FILE);
        Path out = call.text("out").map(Path::of).orElse(TradeReport.folder(level));
        trade.start(level, out, () -> call.ui().show("trade-page"));
        if (trade.page().isEmpty() && !trade.isRunning()) {
            throw new EditorRefusal(call.session().status());
        }
    }
}
