/** Draws the short light of shots: the bolt that flies to a surface, and rings where a portal was refused. */
package nephele.engine.render.pass.shot;
