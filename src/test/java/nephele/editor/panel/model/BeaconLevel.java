package nephele.editor.panel.model;

import java.util.List;
import java.util.Map;
import nephele.engine.level.Material;
import nephele.engine.level.Range;
import nephele.engine.level.Spatial;
import nephele.engine.level.TextKind;
import nephele.engine.level.Written;
import nephele.engine.math.Vec3;

/** A level with an entity that no program knows: what the editor shows of it follows from the record alone. */
public record BeaconLevel(
        @Written(absent = "\"\"") String name,
        @Written List<Material> materials,
        @Written List<BeaconLevel.Beacon> beacons) {
    /** An entity with a component of most kinds. */
    public record Beacon(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 position,
            @Written(absent = "2") @Range(min = 0.5, max = 8) double periodSeconds,
            @Written boolean portalable,
            @Written @Range(min = 0, max = 1) Double gain,
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written @Range List<Vec3> flashes,
            @Written @Range Map<String, Double> weights) {}

    static Beacon beacon(String id, double period, String material) {
        return new Beacon(id, new Vec3(1, 5, 2), period, period > 2, null, material, List.of(), Map.of());
    }

    static BeaconLevel of(Beacon... beacons) {
        Material brick = new Material("brick", new Vec3(1, 0, 0), null, null, null, null, Vec3.ZERO, 1);
        return new BeaconLevel("lights", List.of(brick), List.of(beacons));
    }
}
