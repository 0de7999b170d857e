package nephele.engine.collision;

import nephele.engine.portal.ground.GroundStep;

/**
 * How far the ground around a portal lies below it.
 *
 * @param stepMetres under the portal's rim; {@link GroundStep#NO_GROUND} for a portal on a wall
 * @param deepestMetres within the reach of a body beside the portal; 0 for a portal on a wall
 */
record FrameDepths(double stepMetres, double deepestMetres) {}
