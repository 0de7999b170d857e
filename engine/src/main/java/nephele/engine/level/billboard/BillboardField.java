package nephele.engine.level.billboard;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Billboards;
import nephele.engine.math.Vec3;

/** The places of a field's billboards. */
public final class BillboardField {
    private BillboardField() {}

    /**
     * Plants a field: as many places as asked for, or as find room.
     *
     * @throws nephele.engine.asset.AssetException that names a density map that cannot be used
     */
    public static List<Vec3> plant(Billboards.Field field, Ground ground, AssetSource assets) {
        String map = field.densityMap();
        Picture density = map == null ? null : PictureDecoder.decodeNumbers(map, assets.bytes(map));
        Ground.Area area = ground.area();
        double leastUp = StrictMath.cos(StrictMath.toRadians(field.maxSlopeDegrees()));
        List<Vec3> places = new ArrayList<>();
        PoissonDisc.points(area, field.spacingMetres(), field.count(), field.seed(), (x, z, chance) -> {
            if (density != null
                    && chance >= share(density, (x - area.minX()) / area.width(), (z - area.minZ()) / area.depth())) {
                return false;
            }
            Ground.Place place = ground.at(x, z);
            boolean isGood = place != null && place.normal().y() >= leastUp - 1e-12 && isWithin(field, place);
            if (isGood) {
                places.add(place.at());
            }
            return isGood;
        });
        return places;
    }

    private static boolean isWithin(Billboards.Field field, Ground.Place place) {
        Billboards.HeightLimits heights = field.heightRangeMetres();
        double height = place.at().y();
        return heights == null || height >= heights.low() && height <= heights.high();
    }

    /** Returns the first channel of the nearest pixel, 0 to 1. */
    private static double share(Picture map, double u, double v) {
        int x = Math.min((int) (u * map.width()), map.width() - 1);
        int y = Math.min((int) (v * map.height()), map.height() - 1);
        return map.sample(x, y, 0) / (map.bitsPerChannel() == 8 ? 255.0 : 65535.0);
    }
}
