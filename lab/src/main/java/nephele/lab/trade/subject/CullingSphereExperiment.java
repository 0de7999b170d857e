package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Frustum;
import nephele.engine.model.BoundingSphere;
import nephele.engine.scene.View;
import nephele.engine.xmlscene.PosedScene;
import nephele.engine.xmlscene.WorldSpheres;
import nephele.engine.xmlscene.XmlScene;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import org.joml.Matrix4d;

/** Which models of a scene several views keep, at a time each. */
final class CullingSphereExperiment implements Experiment {
    static final int VIEWS = 24;
    private static final double SECONDS_BETWEEN = 0.7;

    private final StillLife.Generated files = new StillLife.Generated();
    private final List<ReportCulling> reports = new ArrayList<>();
    private final List<BoundingSphere> spheres = new ArrayList<>();
    private final PosedScene posed;
    private final WorldSpheres placed;
    private final List<View> views;
    private final Frustum frustum = Frustum.reusable(6);
    private final Matrix4d clipFromRelative = new Matrix4d();
    /** What the compiler must not leave out. */
    private int kept;

    CullingSphereExperiment() {
        var models = new DriftingModels();
        XmlScene scene = models.scene();
        views = models.views(scene, VIEWS);
        posed = PosedScene.of(scene);
        placed = new WorldSpheres(posed.modelCount());
        CullingSphereSubject.FAULTS.forEach(faults -> reports.add(new ReportCulling(scene, files, faults)));
        for (int model = 0; model < posed.modelCount(); model++) {
            spheres.add(BoundingSphere.of(files.mesh(posed.model(model))));
            place(model);
        }
    }

    private void place(int model) {
        BoundingSphere sphere = spheres.get(model);
        var c = sphere.centre();
        placed.place(model, c.x(), c.y(), c.z(), sphere.radius(), posed.worldFromModel(model));
    }

    /** At the time of a view. */
    private void begin(int view) {
        posed.at(SECONDS_BETWEEN * view);
        for (int model = 0; model < spheres.size(); model++) {
            if (posed.moves(model)) {
                place(model);
            }
        }
        View seen = views.get(view);
        frustum.restart(seen.eyeX(), seen.eyeY(), seen.eyeZ());
        frustum.keepAll(seen.clipFromRelative(clipFromRelative));
    }

    private boolean keeps(int setting, int view, int model) {
        return setting == reports.size()
                ? placed.maySee(model, frustum)
                : reports.get(setting).keeps(model, SECONDS_BETWEEN * view, views.get(view));
    }

    @Override
    public Judgement judge(int setting) {
        var truth = new ModelsInView();
        int seen = 0;
        int leftOut = 0;
        int keptForNothing = 0;
        for (int view = 0; view < VIEWS; view++) {
            begin(view);
            for (int model = 0; model < spheres.size(); model++) {
                boolean isSeen =
                        truth.shows(views.get(view), files.mesh(posed.model(model)), posed.worldFromModel(model));
                boolean keeps = keeps(setting, view, model);
                seen += isSeen ? 1 : 0;
                leftOut += isSeen && !keeps ? 1 : 0;
                keptForNothing += keeps && !isSeen ? 1 : 0;
            }
        }
        int outOfView = VIEWS * spheres.size() - seen;
        return Judgement.of(100.0 * leftOut / seen, 100.0 * keptForNothing / outOfView, (double) leftOut / VIEWS);
    }

    @Override
    public void run(int setting) {
        for (int view = 0; view < VIEWS; view++) {
            if (setting == reports.size()) {
                begin(view);
            }
            for (int model = 0; model < spheres.size(); model++) {
                kept += keeps(setting, view, model) ? 1 : 0;
            }
        }
    }

    @Override
    public void close() {
        kept = 0;
    }
}
