"""Links, joints, Assur groups, contours: a variant as a mechanism, and the velocity equations that follow from its points.

The words of the field.  *Link*: a rigid body (the frame is the fixed one).  *Driven point*: the point whose velocity is given.
*Mobility*: W = 3n - 2p5 - p4.  *Assur group*: links that add no mobility; *dyad*: a group of two links.  *Assembly mode*: which
of the two ways a dyad closes.  *Dead point*: a determinant is zero, and the drive asks for a motion that the links cannot make.
*Change point*: two motions meet.  *Residual*: by how much an equation is not satisfied; *drift*: its growth.  *Analog*: a
derivative with respect to the crank angle.  *Step* h; *scheme*: the rule for making a step.
"""
