package nephele.engine.render.fixed;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import nephele.engine.asset.Picture;
import nephele.engine.model.Mesh;
import nephele.engine.render.fixed.ScenePoses.Placed;
import nephele.engine.xmlscene.XmlModel;

/** The models of a scene that can be shown, numbered so that those drawn by one call follow each other. */
final class ModelOrder {
    private final List<Placed<XmlModel>> models = new ArrayList<>();
    private final List<Run> runs = new ArrayList<>();

    /** Those that stay come first, since they are placed once. */
    enum Motion {
        STAYS,
        MOVES
    }

    /** A mirror turns faces inside out. */
    enum Handedness {
        KEPT,
        MIRRORED
    }

    /** What one draw call has in common. @param picture {@code null} for none */
    record Kind(Motion motion, Mesh mesh, Picture picture, Handedness handedness) {}

    /** The models of a kind are numbered from {@code first} to before {@code end}. */
    record Run(Kind kind, int first, int end) {}

    /** @param moving of all of them, as of an entity that is flown about */
    static ModelOrder of(ScenePoses poses, SceneFiles files, Motion least) {
        Map<Kind, List<Placed<XmlModel>>> byKind = new HashMap<>();
        List<Kind> kinds = new ArrayList<>();
        for (Placed<XmlModel> model : poses.models()) {
            Mesh mesh = files.mesh(model.what());
            if (mesh == null) {
                continue;
            }
            Picture picture = model.what().texture() == null ? null : files.picture(model.what());
            boolean moves = least == Motion.MOVES || model.group().moves();
            boolean mirrored = model.group().place().determinant3x3() < 0;
            Kind kind = new Kind(
                    moves ? Motion.MOVES : Motion.STAYS,
                    mesh,
                    picture,
                    mirrored ? Handedness.MIRRORED : Handedness.KEPT);
            byKind.computeIfAbsent(kind, added -> {
                        kinds.add(added);
                        return new ArrayList<>();
                    })
                    .add(model);
        }
        kinds.sort(Comparator.comparing(Kind::motion));
        ModelOrder order = new ModelOrder();
        for (Kind kind : kinds) {
            int first = order.models.size();
            order.models.addAll(Objects.requireNonNull(byKind.get(kind)));
            order.runs.add(new Run(kind, first, order.models.size()));
        }
        return order;
    }

    List<Placed<XmlModel>> models() {
        return models;
    }

    List<Run> runs() {
        return runs;
    }

    /** How many models stay: the number of the first that moves. */
    int staying() {
        return runs.stream()
                .filter(run -> run.kind().motion() == Motion.STAYS)
                .mapToInt(Run::end)
                .max()
                .orElse(0);
    }
}
