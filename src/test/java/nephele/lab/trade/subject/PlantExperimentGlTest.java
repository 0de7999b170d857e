package nephele.lab.trade.subject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.host.named.OpenedLevel;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.Setting;
import nephele.lab.trade.TradeSite;
import nephele.lab.trade.TradeView;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The ways to draw trees differ, and each of them shows the trees. */
class PlantExperimentGlTest {
    private static final TradeSite.Extent SMALL = new TradeSite.Extent(96, 54, 16);

    @TempDir
    Path folder;

    private TradeSite site(OpenedLevel opened) {
        Projection projection = new Projection(0.8, SMALL.aspect(), 0.1, 1000);
        View view = View.lookAt(new Vec3(0, 5, 48), new Vec3(0, 5, 0), new Vec3(0, 1, 0), projection);
        return new TradeSite(
                opened, new TradeView(view, "test"), SMALL, folder, new PrintStream(OutputStream.nullOutputStream()));
    }

    @Test
    void eachWayShowsTheTreesAndNoTwoShowTheSame() {
        List<Judgement> found = new ArrayList<>();
        try (TradeSite site = site(PlantedTrees.opened());
                PlantExperiment experiment = new PlantExperiment(site)) {
            // Its renderer stays open, and with it the pictures of the trees, which the later ones would take again.
            experiment.run(PlantExperiment.Technique.IMPOSTORS.ordinal());
            for (PlantExperiment.Technique way : PlantExperiment.Technique.values()) {
                found.add(experiment.judge(way.ordinal()));
            }
            double without = errorWithoutTrees(site);
            for (PlantExperiment.Technique way : PlantExperiment.Technique.values()) {
                Judgement judged = found.get(way.ordinal());
                assertEquals(PlantExperiment.FIGURES.size(), judged.figures().size());
                assertTrue(judged.error() < 0.7 * without, way + " errs " + judged.error() + ", no trees " + without);
                assertTrue(judged.figures().get(3) > 0 && judged.figures().get(4) > 0, way + " flickers");
            }
        }
        for (int i = 0; i < found.size(); i++) {
            for (int other = 0; other < i; other++) {
                double apart = Math.abs(found.get(i).error() - found.get(other).error());
                assertTrue(
                        apart > 1e-4,
                        PlantExperiment.Technique.values()[i] + " is " + PlantExperiment.Technique.values()[other]);
            }
        }
        double meshes = found.get(PlantExperiment.Technique.MESHES.ordinal()).error();
        for (PlantExperiment.Technique way : List.of(
                PlantExperiment.Technique.SPRITES,
                PlantExperiment.Technique.CROSSED,
                PlantExperiment.Technique.IMPOSTORS)) {
            assertTrue(found.get(way.ordinal()).error() > meshes, way + " errs less than meshes");
        }
    }

    @Test
    void theReportHasTheSubject() {
        var trade = Trades.named(List.of("treeKind")).get(0);
        assertEquals(5, trade.settings().size());
        assertEquals("mixture", trade.settings().get(trade.usual()).name());
        assertEquals(PlantExperiment.FIGURES, trade.figures());
    }

    private static double errorWithoutTrees(TradeSite site) {
        var bare = new PictureSetting(
                Setting.of("bare"),
                shot -> shot.with(
                        shot.level().with(shot.level().materials(), shot.level().solids(), List.of(), List.of())));
        try (var pictures = new PictureExperiment(site, List.of(bare), ComparedValues.RADIANCE)) {
            return pictures.judge(0).error();
        }
    }
}
