package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Vec3;

/**
 * Ground over a rectangle, its heights from a picture. Heights in this record are metres above {@code centre.y}, so a
 * terrain that is moved keeps its shape and its look.
 *
 * @param heightMap asset id of a grey picture or of raw 16-bit heights ({@code .r16}); its left is at the least x, its
 *     top at the least z
 * @param centre the middle of the rectangle; its y is the level of height 0
 * @param heightRangeMetres the heights of the least and the greatest value that the map can hold
 * @param layers mixed as {@link nephele.engine.level.terrain.TerrainLayers} says; with none the ground is grey
 * @param layerMap asset id of a grey PNG with alpha, or {@code null}: the layers that are painted, as {@link
 *     nephele.engine.level.terrain.LayerPaint} says
 * @param portalable whether portals can be placed where the ground is even to 1 cm
 */
public record Terrain(
        @Written(required = true, text = TextKind.ID) String id,
        @Written(required = true, text = TextKind.ASSET, prototype = "\"terrain/hills.png\"") String heightMap,
        @Written(required = true, spatial = Spatial.POINT) @Range Vec3 centre,
        @Written(required = true, array = true, prototype = "[256, 256]") Sides sizeMetres,
        @Written(required = true, array = true, prototype = "[0, 40]") HeightRange heightRangeMetres,
        @Written(most = 8) List<Layer> layers,
        @Written(text = TextKind.ASSET) String layerMap,
        @Written boolean portalable) {
    /** Creates a terrain without painted layers. */
    public Terrain(
            String id,
            String heightMap,
            Vec3 centre,
            Sides sizeMetres,
            HeightRange heightRangeMetres,
            List<Layer> layers,
            boolean portalable) {
        this(id, heightMap, centre, sizeMetres, heightRangeMetres, layers, null, portalable);
    }

    /** The lengths of the rectangle's sides along x and z. */
    public record Sides(
            @Written(required = true, spatial = Spatial.LENGTH) @Range(min = 0.01, max = 1e6) double x,
            @Written(required = true, spatial = Spatial.LENGTH) @Range(min = 0.01, max = 1e6) double z) {}

    /** The heights of the map's value 0 and of its full scale. */
    public record HeightRange(
            @Written(required = true, spatial = Spatial.LENGTH) @Range(min = -1e5, max = 1e5) double low,
            @Written(required = true, spatial = Spatial.LENGTH) @Range(min = -1e5, max = 1e5) double high) {}

    /**
     * A material between two heights and two slopes.
     *
     * @param blendMetres height over which the layer fades at each of its limits, half of it on either side; 0 for a
     *     sharp limit
     * @param maxSlopeDegrees 90 for no upper limit
     */
    public record Layer(
            @Written(required = true, text = TextKind.ID, refersTo = "materials") String material,
            @Written(absent = "-1e7", spatial = Spatial.LENGTH) @Range double fromMetres,
            @Written(absent = "1e7", spatial = Spatial.LENGTH) @Range double toMetres,
            @Written(spatial = Spatial.LENGTH) @Range(min = 0, max = 1e5) double blendMetres,
            @Written @Range(min = 0, max = 90) double minSlopeDegrees,
            @Written(absent = "90") @Range(min = 0, max = 90) double maxSlopeDegrees) {
        /** Makes a layer of all heights and slopes. */
        public static Layer everywhere(String material) {
            return new Layer(material, -1e7, 1e7, 0, 0, 90);
        }
    }

    /** Returns this terrain with another height map. */
    public Terrain withHeightMap(String file) {
        return RecordCopy.with(this, "heightMap", file);
    }

    /** Returns this terrain with other layers, of which none is painted. */
    public Terrain withLayers(List<Layer> others) {
        return RecordCopy.with(this, "layers", others, "layerMap", null);
    }

    /** Returns this terrain with another layer map, {@code null} for none. */
    public Terrain withLayerMap(String file) {
        return RecordCopy.with(this, "layerMap", file);
    }
}
