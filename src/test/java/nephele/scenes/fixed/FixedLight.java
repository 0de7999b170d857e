package nephele.scenes.fixed;

import java.util.List;
import java.util.Set;
import nephele.scenes.xml.XmlLight;
import nephele.scenes.xml.XmlModel.Colours;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The light model of OpenGL 2.1, section 2.14.1, for white lights without attenuation and ambient part, white global
 * ambient light and a viewer at infinity: the exact twin of {@code fixed-light.glsl}.
 *
 * @param towardsViewer of unit length, the same for all points
 * @param lights in the frame of the points
 */
public record FixedLight(Vector3dc towardsViewer, List<XmlLight> lights, Set<LightTerm> terms) {
    /**
     * Returns the colour of a point, 0–1.
     *
     * @param normal of unit length
     */
    public Vector3d lit(Colours colours, Vector3dc point, Vector3dc normal) {
        var sum = new Vector3d();
        if (terms.contains(LightTerm.AMBIENT)) {
            sum.add(colours.ambient().toVector());
        }
        if (terms.contains(LightTerm.EMISSIVE)) {
            sum.add(colours.emissive().toVector());
        }
        for (XmlLight light : lights) {
            Vector3d towards = towards(light, point);
            if (normal.dot(towards) > 0) {
                sum.fma(spotShare(light, towards), reflected(colours, normal, towards));
            }
        }
        return sum.max(new Vector3d(0)).min(new Vector3d(1));
    }

    private Vector3d reflected(Colours colours, Vector3dc normal, Vector3dc towards) {
        var reflected = new Vector3d();
        if (terms.contains(LightTerm.DIFFUSE)) {
            reflected.fma(normal.dot(towards), colours.diffuse().toVector());
        }
        if (terms.contains(LightTerm.SPECULAR)) {
            Vector3d halfway = unitOrNothing(towards.add(towardsViewer, new Vector3d()));
            double gloss = power(Math.max(normal.dot(halfway), 0), colours.shininess());
            reflected.fma(gloss, colours.specular().toVector());
        }
        return reflected;
    }

    private static Vector3d towards(XmlLight light, Vector3dc position) {
        if (light instanceof XmlLight.Directional directional) {
            return unitOrNothing(directional.towards().toVector());
        }
        var from = light instanceof XmlLight.Point point ? point.position() : ((XmlLight.Spot) light).position();
        return unitOrNothing(from.toVector().sub(position));
    }

    private static double spotShare(XmlLight light, Vector3dc towards) {
        if (!(light instanceof XmlLight.Spot spot) || spot.cutoffDegrees() >= 180) {
            return 1;
        }
        double along = -unitOrNothing(spot.direction().toVector()).dot(towards);
        return along < Math.cos(Math.toRadians(spot.cutoffDegrees())) ? 0 : power(along, spot.exponent());
    }

    private static Vector3d unitOrNothing(Vector3d v) {
        return v.lengthSquared() > 0 ? v.normalize() : v;
    }

    private static double power(double base, double exponent) {
        if (exponent == 0) {
            return 1;
        }
        return base <= 0 ? 0 : Math.pow(base, exponent);
    }
}
