/**
 * Multiply scattered light in clouds in closed form: {@link nephele.engine.cloud.light.CloudLight} from optical depths
 * at a point, {@link nephele.engine.cloud.light.SmallAngleScattering} along a path.
 */
package nephele.engine.cloud.light;
