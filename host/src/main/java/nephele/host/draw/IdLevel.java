package nephele.host.draw;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import nephele.engine.level.Billboards;
import nephele.engine.level.Body;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.math.Vec3;

/**
 * The level of {@code --set debug=ids}: each solid, then each body, each model, each terrain and each group of billboards
 * has a unique flat colour, for plain output. Mirrors stay mirrors.
 */
public final class IdLevel {
    /** Odd, so that 2²⁴ numbers have distinct colours; large, so that neighbours differ. */
    private static final int SPREAD = 0x9e3779;

    /** The inverse of SPREAD modulo 2²⁴. */
    private static final int UNSPREAD = 0xb382c9;

    /** The id of the material of all mirrors, which reflects all light. */
    private static final String MIRROR = "id-mirror";

    private static final Vec3 ONE = new Vec3(1, 1, 1);

    private IdLevel() {}

    /** Returns the level with its surfaces in the colours of {@link #colour}, under flat light, without lights, exits and emitters. */
    public static Level of(Level level) {
        var materials = new ArrayList<Material>();
        var solids = new ArrayList<Solid>();
        var mirrors = MirrorFaces.materials(level.materials());
        for (var solid : level.solids()) {
            var material = flat("id-" + solids.size(), colour(solids.size()));
            materials.add(material);
            solids.add(painted(solid, material.id(), mirrors));
        }
        var bodies = new ArrayList<Body>();
        for (var body : level.bodies()) {
            var material = flat("id-" + materials.size(), colour(materials.size()));
            materials.add(material);
            bodies.add(body.withMaterial(material.id()));
        }
        var models = new ArrayList<ModelPlacement>();
        for (var model : level.models()) {
            var material = flat("id-" + materials.size(), colour(materials.size()));
            materials.add(material);
            models.add(model.withMaterial(material.id()));
        }
        var terrains = new ArrayList<Terrain>();
        for (var terrain : level.terrains()) {
            var material = flat("id-" + materials.size(), colour(materials.size()));
            materials.add(material);
            terrains.add(terrain.withLayers(List.of(Terrain.Layer.everywhere(material.id()))));
        }
        int before = materials.size();
        var billboards = new ArrayList<Billboards>();
        for (var group : level.billboards()) {
            billboards.add(group.withEdges(vector(colour(before + billboards.size()))));
        }
        if (!mirrors.isEmpty()) {
            materials.add(new Material(MIRROR, ONE, null, null, null, null, Vec3.ZERO, 1, true));
        }
        var flatLight = new Environment(null, null, ONE, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
        return level.with(flatLight, List.of())
                .with(materials, solids, bodies, models)
                .withExits(List.of())
                .withEmitters(List.of())
                .withTerrains(terrains)
                .withBillboards(billboards);
    }

    /**
     * Returns the 8-bit colour of a surface, 0xRRGGBB; black means no surface.
     *
     * @param index of a solid, or the number of solids plus the index of a body, or the number of both plus that of a
     *     model, of all three plus that of a terrain, or of all four plus that of a group of billboards
     */
    public static int colour(int index) {
        return (index + 1) * SPREAD & 0xffffff;
    }

    /** Returns the index of the surface with a colour; not a valid index if no surface has it. */
    public static int surface(int colour) {
        return (colour * UNSPREAD & 0xffffff) - 1;
    }

    private static Material flat(String id, int rgb) {
        return new Material(id, vector(rgb), null, null, null, null, Vec3.ZERO, 1);
    }

    private static Vec3 vector(int rgb) {
        return new Vec3((rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0);
    }

    private static Solid painted(Solid solid, String material, Set<String> mirrors) {
        Solid painted = solid.with(solid.id(), material, false, solid.textureMapping());
        if (painted instanceof Solid.Box box) {
            return box.withFaces(mirrors(List.of(BoxFace.values()), box.faces(), solid.material(), mirrors));
        }
        if (painted instanceof Solid.Wedge wedge) {
            return wedge.withFaces(mirrors(SolidFaces.names(wedge), wedge.faces(), solid.material(), mirrors));
        }
        if (painted instanceof Solid.Prism prism) {
            return prism.withFaces(mirrors(SolidFaces.names(prism), prism.faces(), solid.material(), mirrors));
        }
        var planes = (Solid.Planes) painted;
        return planes.withPlanes(planes.planes().stream()
                .map(plane -> new Solid.PlaneFace(
                        plane.normal(),
                        plane.distanceMetres(),
                        isMirror(plane.material(), solid.material(), mirrors) ? MIRROR : null,
                        null,
                        null))
                .collect(Collectors.toList()));
    }

    /** Returns the faces of a solid that are mirrors. */
    private static <N> Map<N, Solid.Face> mirrors(
            List<N> names, Map<N, Solid.Face> faces, String material, Set<String> mirrors) {
        return names.stream()
                .filter(name ->
                        isMirror(faces.containsKey(name) ? faces.get(name).material() : null, material, mirrors))
                .collect(Collectors.toMap(name -> name, name -> new Solid.Face(MIRROR, null, null)));
    }

    private static boolean isMirror(String ofFace, String ofSolid, Set<String> mirrors) {
        return mirrors.contains(ofFace == null ? ofSolid : ofFace);
    }
}
