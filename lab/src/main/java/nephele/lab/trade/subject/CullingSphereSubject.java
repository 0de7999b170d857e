package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import nephele.engine.math.Frustum;
import nephele.engine.model.BoundingSphere;
import nephele.engine.model.Mesh;
import nephele.engine.scene.View;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;
import nephele.lab.trade.subject.ReportCulling.Fault;
import nephele.scenes.xml.PosedScene;
import nephele.scenes.xml.WorldSpheres;
import nephele.scenes.xml.XmlScene;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector4d;

/**
 * The culling spheres of the scene-engine report, with its three errors and with each of them alone, against exact
 * ones.
 */
public final class CullingSphereSubject implements Experiment {
    /** The faults of every setting but the last, which is the exact one. */
    static final List<Set<Fault>> FAULTS = List.of(
            EnumSet.allOf(Fault.class),
            EnumSet.of(Fault.LARGEST_COORDINATE),
            EnumSet.of(Fault.LAST_ROTATION),
            EnumSet.of(Fault.LEFT_POINT));

    static final int VIEWS = 24;
    private static final double SECONDS_BETWEEN = 0.7;
    /** The greatest number of corners of a triangle that six planes have cut. */
    private static final int MOST_CORNERS = 9;

    public static final Trade TRADE = new Trade(
            "cullingSpheres",
            new Trade.Text(
                    "A sphere around each model",
                    "What is outside of the view is found by a sphere around each model of an XML scene: 2 000 models"
                            + " in nested groups that are moved, turned and scaled unevenly, some of them moving. The"
                            + " scene-engine report makes three mistakes, here together and one at a time. What is left"
                            + " out though it is in view is missing in the picture.",
                    "each triangle cut by the planes of the view"),
            List.of(),
            List.of(
                    new Setting("report", "all three mistakes"),
                    new Setting("largestCoordinate", "radius: the largest coordinate; a cube's corner is 73 % farther"),
                    new Setting("lastRotation", "a group's rotation replaces those around it"),
                    new Setting("leftPoint", "the right plane goes through the left plane's point"),
                    new Setting("exact", "the viewer's: follows every step exactly")),
            FAULTS.size(),
            new ErrorMetric("left out though in view", "%", 0.01, 0.01),
            List.of("kept though out of view, %", "models left out wrongly, a view"),
            new CostMetric("CPU a frame", "ms", 1e6, VIEWS, CostMetric.Clock.THREAD),
            null,
            site -> new CullingSphereSubject());

    private final StillLife.Generated files = new StillLife.Generated();
    private final List<ReportCulling> reports = new ArrayList<>();
    private final List<BoundingSphere> spheres = new ArrayList<>();
    private final PosedScene posed;
    private final WorldSpheres placed;
    private final List<View> views;
    private final Frustum frustum = Frustum.reusable(6);
    private final Matrix4d clipFromRelative = new Matrix4d();
    private final Matrix4d clipFromModel = new Matrix4d();
    private final Vector4d[] corners = new Vector4d[MOST_CORNERS];
    private final Vector4d[] cut = new Vector4d[MOST_CORNERS];
    /** Uses the result, so that the compiler cannot eliminate the timed code. */
    private int kept;

    CullingSphereSubject() {
        Arrays.setAll(corners, i -> new Vector4d());
        Arrays.setAll(cut, i -> new Vector4d());
        var models = new DriftingModels();
        XmlScene scene = models.scene();
        views = models.views(scene, VIEWS);
        posed = PosedScene.of(scene);
        placed = new WorldSpheres(posed.modelCount());
        FAULTS.forEach(faults -> reports.add(new ReportCulling(scene, files, faults)));
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

    /** Poses the scene at the time of a view and sets the frustum. */
    private void begin(int view) {
        posed.at(SECONDS_BETWEEN * view);
        for (int model = 0; model < spheres.size(); model++) {
            if (posed.moves(model)) {
                place(model);
            }
        }
        View current = views.get(view);
        frustum.restart(current.eyeX(), current.eyeY(), current.eyeZ());
        frustum.keepAll(current.clipFromRelative(clipFromRelative));
    }

    private boolean keeps(int setting, int view, int model) {
        return setting == reports.size()
                ? placed.maySee(model, frustum)
                : reports.get(setting).keeps(model, SECONDS_BETWEEN * view, views.get(view));
    }

    @Override
    public Judgement judge(int setting) {
        int visible = 0;
        int leftOut = 0;
        int keptOutOfView = 0;
        for (int view = 0; view < VIEWS; view++) {
            begin(view);
            for (int model = 0; model < spheres.size(); model++) {
                boolean isVisible =
                        isVisible(views.get(view), files.mesh(posed.model(model)), posed.worldFromModel(model));
                boolean keeps = keeps(setting, view, model);
                visible += isVisible ? 1 : 0;
                leftOut += isVisible && !keeps ? 1 : 0;
                keptOutOfView += keeps && !isVisible ? 1 : 0;
            }
        }
        int outOfView = VIEWS * spheres.size() - visible;
        return Judgement.of(100.0 * leftOut / visible, 100.0 * keptOutOfView / outOfView, (double) leftOut / VIEWS);
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

    /**
     * Returns true if a view shows any part of a mesh: each triangle is clipped by the six planes in turn (Sutherland and
     * Hodgman, 1974).
     */
    private boolean isVisible(View view, Mesh mesh, Matrix4dc worldFromModel) {
        view.clipFromRelative(clipFromModel).translate(-view.eyeX(), -view.eyeY(), -view.eyeZ());
        clipFromModel.mul(worldFromModel);
        for (int at = 0; at < mesh.indices().length; at += 3) {
            for (int i = 0; i < 3; i++) {
                int p = 3 * mesh.indices()[at + i];
                corners[i].set(mesh.positions()[p], mesh.positions()[p + 1], mesh.positions()[p + 2], 1);
                clipFromModel.transform(corners[i]);
            }
            if (isLeft()) {
                return true;
            }
        }
        return false;
    }

    private boolean isLeft() {
        int count = 3;
        for (int plane = 0; plane < 6 && count > 0; plane++) {
            count = cutBy(plane, count);
        }
        return count > 0;
    }

    private int cutBy(int plane, int count) {
        int kept = 0;
        for (int i = 0; i < count; i++) {
            Vector4d from = corners[i];
            Vector4d to = corners[(i + 1) % count];
            double a = distance(from, plane);
            double b = distance(to, plane);
            if (a >= 0) {
                cut[kept++].set(from);
            }
            if (a >= 0 != b >= 0) {
                from.lerp(to, a / (a - b), cut[kept++]);
            }
        }
        for (int i = 0; i < kept; i++) {
            corners[i].set(cut[i]);
        }
        return kept;
    }

    private static double distance(Vector4d p, int plane) {
        double side = plane % 2 == 0 ? 1 : -1;
        return p.w + side * p.get(plane / 2);
    }
}
