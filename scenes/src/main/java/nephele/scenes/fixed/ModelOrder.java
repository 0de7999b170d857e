package nephele.scenes.fixed;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.Picture;
import nephele.engine.model.Mesh;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.scenes.xml.PosedScene;
import nephele.scenes.xml.XmlModel;

/**
 * The drawable models of a scene in a new order: static models before moving ones, and models of one draw call next to
 * each other.
 */
final class ModelOrder {
    private final List<Integer> posedNumbers = new ArrayList<>();
    private final List<Run> runs = new ArrayList<>();
    private int staying;

    /**
     * The common properties of one draw call.
     *
     * @param moves false for models that are placed once
     * @param picture {@code null} for none
     * @param culled the faces that are left out: a mirroring transform reverses the winding
     */
    record Kind(boolean moves, Mesh mesh, Picture picture, Cull culled) {}

    /** The models of a kind, numbered from {@code first} to before {@code end}. */
    record Run(Kind kind, int first, int end) {}

    private ModelOrder() {}

    /** @param isMovable whether all models move, as those of an entity do */
    static ModelOrder of(PosedScene posed, SceneFiles files, boolean isMovable) {
        Map<Kind, List<Integer>> byKind = new LinkedHashMap<>();
        for (int number = 0; number < posed.modelCount(); number++) {
            Mesh mesh = files.mesh(posed.model(number));
            if (mesh != null) {
                boolean moves = isMovable || posed.moves(number);
                byKind.computeIfAbsent(kind(posed, number, mesh, files, moves), added -> new ArrayList<>())
                        .add(number);
            }
        }
        ModelOrder order = new ModelOrder();
        byKind.entrySet().stream()
                .sorted(Comparator.comparing(entry -> entry.getKey().moves()))
                .forEach(entry -> order.add(entry.getKey(), entry.getValue()));
        return order;
    }

    private static Kind kind(PosedScene posed, int number, Mesh mesh, SceneFiles files, boolean moves) {
        XmlModel model = posed.model(number);
        Picture picture = model.texture() == null ? null : files.picture(model);
        boolean mirrored = posed.worldFromModel(number).determinant3x3() < 0;
        return new Kind(moves, mesh, picture, mirrored ? Cull.FRONT : Cull.BACK);
    }

    private void add(Kind kind, List<Integer> numbers) {
        int first = posedNumbers.size();
        posedNumbers.addAll(numbers);
        runs.add(new Run(kind, first, posedNumbers.size()));
        staying = kind.moves() ? staying : posedNumbers.size();
    }

    int count() {
        return posedNumbers.size();
    }

    /** Returns the number of a model in the posed scene. */
    int posedNumber(int number) {
        return posedNumbers.get(number);
    }

    List<Run> runs() {
        return runs;
    }

    /** Returns the number of static models, which is the index of the first moving one. */
    int staying() {
        return staying;
    }
}
