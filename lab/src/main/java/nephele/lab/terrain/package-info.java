/** Makes height maps: noise shaped into ridges and valleys, then eroded by running water. */
package nephele.lab.terrain;
